# How a room of src/ becomes a target: compile options in one place, tests beside the code.

# Warnings are errors by default only for the compilers that are tested on every commit, so that a
# newer compiler's new warning does not stop a user's build.
set(SNELL_KNOWN_COMPILER OFF)
if((CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13) OR
   (CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 15))
  set(SNELL_KNOWN_COMPILER ${PROJECT_IS_TOP_LEVEL})
endif()

# Apply the project's language level, warnings and floating-point rules to a target.
#
# -ffp-contract=off and the absence of -ffast-math are part of the promise that a picture is the same
# bit for bit on every instruction set (docs/decisions/002-bit-equality.md). -fno-math-errno and
# -fno-trapping-math change no result; they let sqrt and floor become instructions.
function(snell_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Wdouble-promotion -Wfloat-conversion
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>  # false alarms of GCC 12 on std::string (bug 105329)
    -ffp-contract=off -fno-math-errno -fno-trapping-math -fvisibility=hidden)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64|amd64")
    target_compile_options(${target} PRIVATE -msse4.2)
  endif()
  if(SNELL_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(SNELL_SANITIZE)
    target_compile_options(${target} PRIVATE
      -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
    target_link_options(${target} PRIVATE -fsanitize=address,undefined)
  endif()
  if(SNELL_BUILD_FUZZERS)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
endfunction()

# snell_room(name SOURCES ... [LINK rooms and libraries] [PRIVATE_LINK libraries])
# makes the static library snell_<name> with the alias snell::<name>.
function(snell_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
  add_library(snell_${name} STATIC ${ROOM_SOURCES})
  add_library(snell::${name} ALIAS snell_${name})
  target_include_directories(snell_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>)
  target_link_libraries(snell_${name} PUBLIC ${ROOM_LINK} PRIVATE ${ROOM_PRIVATE_LINK})
  snell_options(snell_${name})
endfunction()

# snell_test(name SOURCES ... [LINK rooms]) makes a GoogleTest program whose tests CTest runs one by one.
# Sources may be given relative to the current directory.
function(snell_test name)
  cmake_parse_arguments(TEST "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${TEST_SOURCES})
  target_link_libraries(${name} PRIVATE ${TEST_LINK} GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE SNELL_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  snell_options(${name})
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 600)
endfunction()
