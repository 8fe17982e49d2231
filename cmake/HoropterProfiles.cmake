# HOROPTER_PROFILES: the names in profiles.def, which is the only list of profiles.
set(_profiles_def ${PROJECT_SOURCE_DIR}/hls/include/horopter/hls/profiles.def)
set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${_profiles_def})
file(STRINGS ${_profiles_def} _lines REGEX "^HOROPTER_PROFILE\\(")
set(HOROPTER_PROFILES)
foreach(_line IN LISTS _lines)
  string(REGEX MATCH "^HOROPTER_PROFILE\\( *([a-z0-9_]+)" _ "${_line}")
  list(APPEND HOROPTER_PROFILES ${CMAKE_MATCH_1})
endforeach()
