# hlsc's runs: for every profile every stage of hls/stages/stage_list.def that its rules need.
#
#   horopter_hlsc(<directory> STAGE <header> CLASS <C++ type> NAME <module> CLOCK_NS <ns> [OPTIONS <option of hlsc>...])
#
# makes <directory>/<module>.sv and .json of one stage.
#
#   horopter_generate_stages(<profile>)
#
# makes, in the build tree, horopter_<stage>.sv and .json of each stage; sets HOROPTER_GENERATED_<profile>_SOURCES and
# _SIDECARS, HOROPTER_HLSC_OF_<profile>_<stage>, the clock and the options of each run for horopter_hlsc, and the target
# horopter_generated_<profile>. The test generated_<profile> compares them with what is
# committed in rtl/generated/<profile>; the target `regenerate` (scripts/generate-rtl) commits to that folder instead.
include_guard(GLOBAL)

set(_stage_list ${PROJECT_SOURCE_DIR}/hls/stages/stage_list.def)
set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${_stage_list})
file(STRINGS ${_stage_list} _lines REGEX "^HOROPTER_STAGE\\(")
set(HOROPTER_STAGES)
foreach(_line IN LISTS _lines)
  string(REGEX MATCH "^HOROPTER_STAGE\\( *([a-z0-9_]+) *, *([A-Za-z0-9_]+) *, *([a-z]+) *, *([a-z]+)" _ "${_line}")
  list(APPEND HOROPTER_STAGES ${CMAKE_MATCH_1})
  set(HOROPTER_STAGE_CLASS_${CMAKE_MATCH_1} ${CMAKE_MATCH_2})
  set(HOROPTER_STAGE_RULE_${CMAKE_MATCH_1} ${CMAKE_MATCH_3})
  set(HOROPTER_STAGE_PLACE_${CMAKE_MATCH_1} ${CMAKE_MATCH_4})
endforeach()

# Every header that a stage may include: hlsc gives no dependency file.
file(GLOB_RECURSE HOROPTER_STAGE_HEADERS CONFIGURE_DEPENDS
  ${PROJECT_SOURCE_DIR}/hls/include/*.hpp ${PROJECT_SOURCE_DIR}/hls/include/*.def ${PROJECT_SOURCE_DIR}/hls/stages/*.hpp)

set(HOROPTER_HLSC_TARGET ecp5 CACHE STRING "Delay model of the committed modules")
# The rest of the clock is for what the delay model does not know: routing detours, skew.
set(HOROPTER_HLSC_CLOCK_PERCENT 80 CACHE STRING "Percent of a profile's clock period that hlsc may fill with logic")
# Slower profiles are scheduled as if for this: all of them reach 30 MHz, on an iCE40 HX, too.
set(HOROPTER_HLSC_SLOWEST_KHZ 32000 CACHE STRING "Least clock for which hlsc schedules")
# In slow profiles some stages hand on logic instead of registers: the ns after the clock by which it ends, and at which
# the next stage of the list takes it. The image store hands on its memories' data, in 5.9 ns: this path may use 3.6 ns of
# the margin.
set(HOROPTER_HLSC_OUTPUT_NS
  lowpass 14 sobel 12 difference 9 texture 1 threshold 4 majority 6 align 12 runs 15)
set(HOROPTER_HLSC_INPUT_NS interpolate 2.3)
# In slow profiles stages whose chains of additions take longer in gates, where carries ripple, than the model's: the ns that
# they may fill.
set(HOROPTER_HLSC_STAGE_NS direction 22)

# Profiles that have room for a parity bit with each word of the memories of the chain's stages: gates in field, look-up tables
# and block memories in hd are used up.
set(HOROPTER_HLSC_RAM_PARITY vga)

function(_horopter_profile_line profile result)
  file(STRINGS ${PROJECT_SOURCE_DIR}/hls/include/horopter/hls/profiles.def line REGEX "^HOROPTER_PROFILE\\(${profile},")
  set(${result} ${line} PARENT_SCOPE)
endfunction()

function(_horopter_clock_ns profile result slow)
  _horopter_profile_line(${profile} line)
  string(REGEX MATCH "([0-9]+)\\)$" _ "${line}")  # the last column: clock_khz
  set(clock_khz ${CMAKE_MATCH_1})
  if(clock_khz LESS HOROPTER_HLSC_SLOWEST_KHZ)
    set(clock_khz ${HOROPTER_HLSC_SLOWEST_KHZ})
  endif()
  math(EXPR ps "10000000 * ${HOROPTER_HLSC_CLOCK_PERCENT} / ${clock_khz}")
  math(EXPR ns "${ps} / 1000")
  math(EXPR hundredths "${ps} % 1000 / 10")
  if(hundredths LESS 10)
    set(hundredths 0${hundredths})
  endif()
  set(${result} ${ns}.${hundredths} PARENT_SCOPE)
  set(${slow} OFF PARENT_SCOPE)
  if(clock_khz EQUAL HOROPTER_HLSC_SLOWEST_KHZ)
    set(${slow} ON PARENT_SCOPE)
  endif()
endfunction()

# The value behind `key` in a list of keys and values.
function(_horopter_lookup list key result default)
  list(FIND ${list} ${key} at)
  set(value "${default}")
  if(NOT at EQUAL -1)
    math(EXPR at "${at} + 1")
    list(GET ${list} ${at} value)
  endif()
  set(${result} "${value}" PARENT_SCOPE)
endfunction()

function(horopter_hlsc dir)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "STAGE;CLASS;NAME;CLOCK_NS" "OPTIONS")
  add_custom_command(
    OUTPUT ${dir}/${arg_NAME}.sv ${dir}/${arg_NAME}.json
    COMMAND hlsc ${arg_STAGE} --class ${arg_CLASS} --top-name ${arg_NAME} --target ${HOROPTER_HLSC_TARGET}
            --clock-ns ${arg_CLOCK_NS} ${arg_OPTIONS} -I ${PROJECT_SOURCE_DIR}/hls/include -I ${PROJECT_SOURCE_DIR}/hls
            --source-root ${PROJECT_SOURCE_DIR} -o ${dir}
    DEPENDS hlsc ${arg_STAGE} ${HOROPTER_STAGE_HEADERS}
    COMMENT "hlsc ${arg_CLASS}"
    VERBATIM)
endfunction()

function(horopter_generate_stages profile)
  set(dir ${PROJECT_BINARY_DIR}/generated/${profile})
  set(committed ${PROJECT_SOURCE_DIR}/rtl/generated/${profile})
  _horopter_clock_ns(${profile} clock_ns slow)
  set(before)  # output_ns of the stage before
  set(sources)
  set(sidecars)
  _horopter_profile_line(${profile} line)
  string(REGEX MATCH "thesis|compete|both" decisions "${line}")
  foreach(stage IN LISTS HOROPTER_STAGES)
    set(rule ${HOROPTER_STAGE_RULE_${stage}})
    if(NOT rule STREQUAL always AND NOT decisions STREQUAL both AND NOT rule STREQUAL decisions)
      continue()
    endif()
    set(options)
    set(stage_ns ${clock_ns})
    if(slow)
      _horopter_lookup(HOROPTER_HLSC_STAGE_NS ${stage} stage_ns ${clock_ns})
      _horopter_lookup(HOROPTER_HLSC_INPUT_NS ${stage} input "${before}")
      _horopter_lookup(HOROPTER_HLSC_OUTPUT_NS ${stage} before "")
      if(input)
        list(APPEND options --input-ns ${input})
      endif()
      if(before)
        list(APPEND options --output-ns ${before})
      endif()
    endif()
    if(profile IN_LIST HOROPTER_HLSC_RAM_PARITY AND NOT HOROPTER_STAGE_PLACE_${stage} STREQUAL beside)
      list(APPEND options --ram-parity)
    endif()
    set(run CLOCK_NS ${stage_ns} OPTIONS ${options})
    set(HOROPTER_HLSC_OF_${profile}_${stage} "${run}" PARENT_SCOPE)
    horopter_hlsc(${dir} STAGE ${PROJECT_SOURCE_DIR}/hls/stages/${stage}.hpp NAME horopter_${stage}
      CLASS "horopter::stages::${HOROPTER_STAGE_CLASS_${stage}}<horopter::hls::profiles::${profile}>" ${run})
    list(APPEND sources ${dir}/horopter_${stage}.sv)
    list(APPEND sidecars ${dir}/horopter_${stage}.json)
  endforeach()
  add_custom_target(horopter_generated_${profile} DEPENDS ${sources} ${sidecars})

  if(NOT TARGET regenerate)
    add_custom_target(regenerate)
  endif()
  add_custom_target(regenerate_${profile}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${committed}
    COMMAND ${CMAKE_COMMAND} -E copy_if_different ${sources} ${sidecars} ${committed}
    DEPENDS ${sources} ${sidecars}
    COMMENT "rtl/generated/${profile}"
    VERBATIM)
  add_dependencies(regenerate regenerate_${profile})

  add_test(NAME generated_${profile}
    COMMAND ${CMAKE_COMMAND} -D MADE=${dir} -D COMMITTED=${committed} -P ${PROJECT_SOURCE_DIR}/cmake/CompareGenerated.cmake)

  set(HOROPTER_GENERATED_${profile}_SOURCES ${sources} PARENT_SCOPE)
  set(HOROPTER_GENERATED_${profile}_SIDECARS ${sidecars} PARENT_SCOPE)
endfunction()
