# Settings that every target of the project shares, as the interface target horopter_options.
option(HOROPTER_WERROR "Treat warnings as errors" OFF)
option(HOROPTER_COSIM "Build the Verilated models: the rtl engine, and what checks the hardware" ON)
option(HOROPTER_DEVELOPMENT "Build also what users do not run: hlsc, tests, benches, benchmarks" ON)
set(HOROPTER_SANITIZE "" CACHE STRING "Sanitizers, as for -fsanitize=")

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

find_program(HOROPTER_CCACHE ccache)
if(HOROPTER_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Precompiled headers are the same when their text is: ccache need not look at their times.
  set(CMAKE_CXX_COMPILER_LAUNCHER
    ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
    ${HOROPTER_CCACHE})
endif()

# LLVM's linker takes a fifth of the time of GNU ld, which is where it is not.
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=lld HOROPTER_LLD)
if(HOROPTER_LLD)
  add_link_options(-fuse-ld=lld)
endif()

# horopter_precompile(<target> <header>…): headers of other projects that most files of the target include. A target that
# another one's headers fit takes them by target_precompile_headers(… REUSE_FROM …).
function(horopter_precompile target)
  list(TRANSFORM ARGN REPLACE "(.+)" "<\\1>" OUTPUT_VARIABLE headers)
  target_precompile_headers(${target} PRIVATE ${headers})
  target_compile_options(${target} PRIVATE "SHELL:-Xclang -fno-pch-timestamp")
endfunction()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)

add_library(horopter_options INTERFACE)
# Nobody reads errno; without it loops with square roots are vectorised.
target_compile_options(horopter_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -fno-math-errno)
if(HOROPTER_WERROR)
  target_compile_options(horopter_options INTERFACE -Werror)
endif()
if(HOROPTER_SANITIZE)
  # Left out: what the address sanitizer finds as well, at half the time to compile.
  add_compile_options(-fsanitize=${HOROPTER_SANITIZE} -fno-sanitize=null,alignment,object-size,vptr,pointer-overflow
                      -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${HOROPTER_SANITIZE})
endif()
