# Verilated models as CMake libraries.
#
#   horopter_verilate(<target> TOP <module> SOURCES <file>...
#                     [PARAMETERS NAME=value...] [FLAGS <verilator flag>...] [DEPENDS <file or target>...])
#
# makes the static library <target> with the class V<target> (header "V<target>.h"), linked to the one compiled
# Verilator runtime that all models share. The assertions of the SystemVerilog are kept (they cost 2 % of the speed): one
# that fails throws horopter::verilated::Stopped out of eval(). What Verilator has made lies in the target's property
# HOROPTER_MODEL_DIR. The model's own sources come as two files, the one that runs every clock
# optimised for speed, the other (constructors, initial values) for compile time.
include_guard(GLOBAL)

find_program(HOROPTER_VERILATOR NAMES verilator REQUIRED)

if(NOT DEFINED HOROPTER_VERILATOR_ROOT)
  execute_process(COMMAND ${HOROPTER_VERILATOR} --getenv VERILATOR_ROOT
                  OUTPUT_VARIABLE _root OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  set(HOROPTER_VERILATOR_ROOT ${_root} CACHE INTERNAL "where Verilator keeps its runtime")
endif()

set(HOROPTER_VERILATED_DIR ${CMAKE_CURRENT_LIST_DIR}/verilated CACHE INTERNAL "support files of the models")
set(HOROPTER_VERILATE_AMALGAMATE ${CMAKE_CURRENT_LIST_DIR}/verilated/amalgamate.cmake CACHE INTERNAL "")
set(HOROPTER_MODEL_OPTIMISATION "-O3" CACHE STRING "Optimisation of the part of Verilated models that runs every clock")

function(horopter_verilated_runtime)
  if(TARGET horopter_verilated_runtime)
    return()
  endif()
  set(include ${HOROPTER_VERILATOR_ROOT}/include)
  add_library(horopter_verilated_runtime STATIC
    ${include}/verilated.cpp ${include}/verilated_threads.cpp ${HOROPTER_VERILATED_DIR}/stop.cpp)
  target_include_directories(horopter_verilated_runtime PUBLIC ${HOROPTER_VERILATED_DIR}/include)
  target_include_directories(horopter_verilated_runtime SYSTEM PUBLIC ${include} ${include}/vltstd)
  target_compile_features(horopter_verilated_runtime PUBLIC cxx_std_20)
  target_compile_definitions(horopter_verilated_runtime
    PUBLIC VL_TIME_CONTEXT VM_COVERAGE=0 VM_SC=0 VM_TRACE=0 VM_TRACE_FST=0 VM_TRACE_VCD=0
    PRIVATE VL_USER_STOP VL_USER_FATAL VL_USER_FINISH)
  target_compile_options(horopter_verilated_runtime PRIVATE -O2 -w)
  find_package(Threads REQUIRED)
  target_link_libraries(horopter_verilated_runtime PUBLIC Threads::Threads)
endfunction()

function(horopter_verilate target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "TOP" "SOURCES;PARAMETERS;FLAGS;DEPENDS")
  if(NOT arg_TOP OR NOT arg_SOURCES OR arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "horopter_verilate(${target} TOP <module> SOURCES <file>...): ${arg_UNPARSED_ARGUMENTS}")
  endif()
  horopter_verilated_runtime()

  set(dir ${CMAKE_CURRENT_BINARY_DIR}/${target}.verilated)
  set(flags --cc --assert --prefix V${target} --top-module ${arg_TOP} -Mdir ${dir} -O3
            # Registers without a reset and x values are random, by the seed of the VerilatedContext.
            --x-assign unique --x-initial unique
            --output-split-cfuncs 20000)
  foreach(parameter IN LISTS arg_PARAMETERS)
    list(APPEND flags -G${parameter})
  endforeach()
  list(APPEND flags ${arg_FLAGS})

  set(fast ${dir}/V${target}_fast.cpp)
  set(slow ${dir}/V${target}_slow.cpp)
  add_custom_command(
    OUTPUT ${fast} ${slow} ${dir}/V${target}.h
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${dir}
    COMMAND ${HOROPTER_VERILATOR} ${flags} ${arg_SOURCES}
    COMMAND ${CMAKE_COMMAND} -D DIR=${dir} -D PREFIX=V${target} -P ${HOROPTER_VERILATE_AMALGAMATE}
    DEPENDS ${arg_SOURCES} ${arg_DEPENDS} ${HOROPTER_VERILATE_AMALGAMATE}
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
    COMMENT "Verilating ${target}"
    VERBATIM)

  add_library(${target} STATIC ${fast} ${slow})
  set_source_files_properties(${fast} PROPERTIES COMPILE_OPTIONS "${HOROPTER_MODEL_OPTIMISATION};-w")
  set_source_files_properties(${slow} PROPERTIES COMPILE_OPTIONS "-O0;-w")
  target_include_directories(${target} SYSTEM PUBLIC ${dir})
  target_link_libraries(${target} PUBLIC horopter_verilated_runtime)
  set_target_properties(${target} PROPERTIES HOROPTER_MODEL_DIR ${dir})
endfunction()
