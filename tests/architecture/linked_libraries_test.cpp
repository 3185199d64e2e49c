// The program must not pull in window toolkits through the libraries it links.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

namespace gripscan {
namespace {

constexpr std::array<std::string_view, 8> kForbidden{"libQt",
                                                     "libvtkGUI",
                                                     "libvtkInteraction",
                                                     "libvtkRenderingOpenGL2",
                                                     "libvtkRenderingUI",
                                                     "libvtkRenderingQt",
                                                     "libopencv_highgui",
                                                     "libopencv_viz"};

std::vector<std::string> forbidden_in(const std::string& ldd_output) {
    std::vector<std::string> found;
    std::istringstream words(ldd_output);
    for (std::string word; words >> word;) {
        for (const std::string_view name : kForbidden) {
            if (word.starts_with(name)) found.push_back(word);
        }
    }
    return found;
}

std::string output_of(const std::string& command) {
    std::string text;
    FILE* pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) return text;
    std::array<char, 4096> buffer{};
    while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
        text.append(buffer.data(), n);
    }
    ::pclose(pipe);
    return text;
}

TEST(LinkedLibraries, HoldNoWindowToolkit) {
    const std::string libraries = output_of("ldd '" GRIPSCAN_PROGRAM "'");
    ASSERT_THAT(libraries, testing::HasSubstr("libc.so"));
    EXPECT_THAT(libraries, testing::HasSubstr("libopencv_core"));  // else nothing was looked at
    EXPECT_THAT(libraries, testing::Not(testing::HasSubstr("not found")));
    EXPECT_THAT(forbidden_in(libraries), testing::IsEmpty());
}

TEST(LinkedLibraries, TheCheckSeesWhatIsForbidden) {
    EXPECT_THAT(forbidden_in("\tlibQt5Core.so.5 => /usr/lib/libQt5Core.so.5 (0x0)\n"
                             "\tlibvtkRenderingCore-9.1.so.1 => /usr/lib/x (0x0)\n"
                             "\tlibvtkRenderingOpenGL2-9.1.so.1 => /usr/lib/x (0x0)\n"
                             "\tlibopencv_viz.so.406 => /usr/lib/x (0x0)\n"),
                testing::ElementsAre("libQt5Core.so.5", "libvtkRenderingOpenGL2-9.1.so.1",
                                     "libopencv_viz.so.406"));
}

}  // namespace
}  // namespace gripscan
