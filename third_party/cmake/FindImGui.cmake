# Dear ImGui with its GLFW and OpenGL 3 backends (Debian: libimgui-dev) -> target ImGui::imgui
# Debian's pkg-config file names none of the libraries that the static archive needs.
find_path(ImGui_INCLUDE_DIR imgui.h PATH_SUFFIXES imgui)
find_library(ImGui_LIBRARY imgui)
find_library(ImGui_STB_LIBRARY stb)
find_package(Freetype REQUIRED)
find_package(glfw3 3.3 REQUIRED)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(ImGui REQUIRED_VARS
  ImGui_LIBRARY ImGui_INCLUDE_DIR ImGui_STB_LIBRARY)
if(ImGui_FOUND AND NOT TARGET ImGui::imgui)
  add_library(ImGui::imgui STATIC IMPORTED)
  set_target_properties(ImGui::imgui PROPERTIES
    IMPORTED_LOCATION ${ImGui_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES "${ImGui_INCLUDE_DIR};${ImGui_INCLUDE_DIR}/backends"
    INTERFACE_LINK_LIBRARIES "glfw;Freetype::Freetype;${ImGui_STB_LIBRARY};${CMAKE_DL_LIBS}")
endif()
