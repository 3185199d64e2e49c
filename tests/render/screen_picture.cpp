#include "tests/render/screen_picture.h"

#include <gtest/gtest.h>

#include "tests/support/ui_driver.h"
#include "ui/gl/render_target.h"
#include "ui/shell/imgui_painter.h"

namespace gripscan::test {

Picture screen_picture(int width_px, int height_px, ui::Scale scale, ui::ThemeChoice theme,
                       const std::function<void(const ui::Ui&)>& draw) {
    UiDriver driver(width_px, height_px, draw, scale, theme);
    auto painter = ui::ImGuiPainter::make();
    auto target = ui::RenderTarget::make(width_px, height_px, ui::DepthTexture::kNone);
    if (!painter || !target) {
        ADD_FAILURE() << (painter ? target.error().message : painter.error().message);
        return {};
    }
    for (int i = 0; i < 3; ++i) {
        (*painter)->begin_frame(driver.session().fonts_changed());
        driver.frame();
    }
    target->bind();
    glClearColor(1, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    (*painter)->paint();
    return {width_px, height_px, target->read_rgba()};
}

}  // namespace gripscan::test
