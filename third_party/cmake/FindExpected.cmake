# tl::expected (Debian: libexpected-dev), header only -> target tl::expected
find_path(Expected_INCLUDE_DIR tl/expected.hpp)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Expected REQUIRED_VARS Expected_INCLUDE_DIR)
if(Expected_FOUND AND NOT TARGET tl::expected)
  add_library(tl::expected INTERFACE IMPORTED)
  target_include_directories(tl::expected SYSTEM INTERFACE ${Expected_INCLUDE_DIR})
endif()
