# OpenCV 4 by component (Debian: libopencv-dev, libopencv-contrib-dev)
#   -> targets OpenCVParts::core imgproc imgcodecs calib3d features2d flann aruco
# OpenCV's own package config names every module, highgui and viz (Qt, VTK windows) among them.
find_path(OpenCVParts_INCLUDE_DIR opencv2/core.hpp PATH_SUFFIXES opencv4)
set(_opencv_parts core imgproc imgcodecs calib3d features2d flann aruco)
set(_opencv_vars)
foreach(part IN LISTS _opencv_parts)
  find_library(OpenCVParts_${part}_LIBRARY opencv_${part})
  list(APPEND _opencv_vars OpenCVParts_${part}_LIBRARY)
endforeach()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenCVParts
  REQUIRED_VARS OpenCVParts_INCLUDE_DIR ${_opencv_vars})
if(OpenCVParts_FOUND)
  foreach(part IN LISTS _opencv_parts)
    if(NOT TARGET OpenCVParts::${part})
      add_library(OpenCVParts::${part} UNKNOWN IMPORTED)
      set_target_properties(OpenCVParts::${part} PROPERTIES
        IMPORTED_LOCATION ${OpenCVParts_${part}_LIBRARY}
        INTERFACE_INCLUDE_DIRECTORIES ${OpenCVParts_INCLUDE_DIR})
    endif()
  endforeach()
  target_link_libraries(OpenCVParts::imgproc INTERFACE OpenCVParts::core)
  target_link_libraries(OpenCVParts::imgcodecs INTERFACE OpenCVParts::imgproc)
  target_link_libraries(OpenCVParts::features2d INTERFACE OpenCVParts::flann OpenCVParts::imgproc)
  target_link_libraries(OpenCVParts::calib3d INTERFACE OpenCVParts::features2d)
  target_link_libraries(OpenCVParts::aruco INTERFACE OpenCVParts::calib3d)
endif()
