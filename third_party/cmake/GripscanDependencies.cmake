# Every third-party library, found once. Headers are SYSTEM includes (imported targets);
# PCL and OpenCV are linked by component, so that no window toolkit comes along.

find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nanoflann REQUIRED)
find_package(assimp REQUIRED)
find_package(Expected REQUIRED)
find_package(OpenCVParts REQUIRED)
find_package(PclParts REQUIRED)
find_package(Embree REQUIRED)
if(GRIPSCAN_TESTS)
  find_package(GTest REQUIRED)
  include(GoogleTest)
endif()
