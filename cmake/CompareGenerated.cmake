# Fails unless the modules that hlsc makes now are those in rtl/generated.
#   cmake -D MADE=<dir> -D COMMITTED=<dir> -P CompareGenerated.cmake
cmake_policy(SET CMP0057 NEW)  # IN_LIST
set(different)
file(GLOB made RELATIVE ${MADE} ${MADE}/horopter_*.sv ${MADE}/horopter_*.json)
file(GLOB sidecars RELATIVE ${COMMITTED} ${COMMITTED}/horopter_*.json)
foreach(name IN LISTS made)
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${MADE}/${name} ${COMMITTED}/${name}
                  RESULT_VARIABLE result OUTPUT_QUIET ERROR_QUIET)
  if(NOT result EQUAL 0)
    list(APPEND different "${name} differs or is missing")
  endif()
endforeach()
foreach(name IN LISTS sidecars)
  if(NOT name IN_LIST made)
    list(APPEND different "${name} is no stage any more")
  endif()
endforeach()
list(LENGTH made count)
if(different OR count EQUAL 0)
  list(JOIN different "\n  " text)
  message(FATAL_ERROR "${COMMITTED} is not what hlsc makes (${count} files made):\n  ${text}\nmend with: scripts/generate-rtl")
endif()
message(STATUS "${count} files equal")
