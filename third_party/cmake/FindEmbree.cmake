# Embree 3 ray tracing kernels (Debian: libembree-dev) -> target Embree::embree
find_path(Embree_INCLUDE_DIR embree3/rtcore.h)
find_library(Embree_LIBRARY embree3)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Embree REQUIRED_VARS Embree_LIBRARY Embree_INCLUDE_DIR)
if(Embree_FOUND AND NOT TARGET Embree::embree)
  add_library(Embree::embree UNKNOWN IMPORTED)
  set_target_properties(Embree::embree PROPERTIES
    IMPORTED_LOCATION ${Embree_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${Embree_INCLUDE_DIR})
endif()
