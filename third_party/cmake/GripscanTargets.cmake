# How every target of gripscan is made: one library per folder, the same warnings as errors.

add_library(gripscan_options INTERFACE)
target_compile_options(gripscan_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Werror
  # Results must be the same whatever the optimiser contracts: no fused multiply-add by surprise.
  -ffp-contract=off)
target_include_directories(gripscan_options INTERFACE ${PROJECT_SOURCE_DIR})
if(GRIPSCAN_SANITIZE)
  target_compile_options(gripscan_options INTERFACE
    -fsanitize=${GRIPSCAN_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(gripscan_options INTERFACE -fsanitize=${GRIPSCAN_SANITIZE})
  # With a sanitizer GCC sees false uses of unset values, in its own <regex> and <variant> too. The
  # unsanitized build keeps the warning.
  target_compile_options(gripscan_options INTERFACE -Wno-maybe-uninitialized)
  # Asio's headers have fences, which ThreadSanitizer does not know; nothing of ours rests on them.
  if(GRIPSCAN_SANITIZE MATCHES "thread")
    target_compile_options(gripscan_options INTERFACE -Wno-tsan)
  endif()
endif()

# gripscan_library(NAME PUBLIC targets... PRIVATE targets...)
# The folder's *.cpp become the static library gripscan_NAME.
function(gripscan_library name)
  cmake_parse_arguments(ARG "" "" "PUBLIC;PRIVATE" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  if(sources)
    add_library(gripscan_${name} STATIC ${sources})
    target_link_libraries(gripscan_${name}
      PUBLIC ${ARG_PUBLIC} PRIVATE gripscan_options ${ARG_PRIVATE})
    target_include_directories(gripscan_${name} PUBLIC ${PROJECT_SOURCE_DIR})
  else()
    add_library(gripscan_${name} INTERFACE)
    target_link_libraries(gripscan_${name} INTERFACE ${ARG_PUBLIC})
    target_include_directories(gripscan_${name} INTERFACE ${PROJECT_SOURCE_DIR})
  endif()
endfunction()

# gripscan_test(NAME LINK targets...): the folder's *_test.cpp become the program NAME,
# each of its cases a test of its own. ALONE: nothing runs beside them.
function(gripscan_test name)
  cmake_parse_arguments(ARG "ALONE" "TIMEOUT" "LINK;SOURCES" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 120)
  endif()
  if(NOT ARG_SOURCES)
    file(GLOB ARG_SOURCES CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*_test.cpp)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE gripscan_options ${ARG_LINK} gripscan_test_support
    GTest::gmock GTest::gtest_main)
  gtest_discover_tests(${name} TEST_PREFIX ${name}. DISCOVERY_MODE PRE_TEST
    PROPERTIES TIMEOUT ${ARG_TIMEOUT} RUN_SERIAL ${ARG_ALONE})
endfunction()
