#include "ui/fonts/font_set.h"

#include <algorithm>
#include <string>
#include <vector>

#include "ui/resources/resource_file.h"

namespace gripscan::ui {
namespace {

/// Dear ImGui's font size is ascender − descender; this is that height in em, from the file's hhea.
constexpr float kInterHeight = 1.2102F;
constexpr float kMonoHeight = 1.32F;
constexpr float kIconHeight = 1.0F;

struct Face {
    FontRole role;
    const char* file;
    float size_em;
    float height;
};

constexpr std::array kFaces{
    Face{FontRole::kHeading, "Inter-Bold.otf", 2.00F, kInterHeight},
    Face{FontRole::kTitle, "Inter-Bold.otf", 1.43F, kInterHeight},
    Face{FontRole::kTitleLight, "Inter-Regular.otf", 1.43F, kInterHeight},
    Face{FontRole::kVerdict, "Inter-Bold.otf", 1.14F, kInterHeight},
    Face{FontRole::kText, "Inter-Regular.otf", 1.00F, kInterHeight},
    Face{FontRole::kTextStrong, "Inter-SemiBold.otf", 1.00F, kInterHeight},
    Face{FontRole::kButton, "Inter-Medium.otf", 0.96F, kInterHeight},
    Face{FontRole::kNextAction, "Inter-Bold.otf", 1.07F, kInterHeight},
    Face{FontRole::kPanelTitle, "Inter-SemiBold.otf", 0.93F, kInterHeight},
    Face{FontRole::kTable, "Inter-Regular.otf", 0.89F, kInterHeight},
    Face{FontRole::kTableStrong, "Inter-SemiBold.otf", 0.89F, kInterHeight},
    Face{FontRole::kSmall, "Inter-Regular.otf", 0.86F, kInterHeight},
    Face{FontRole::kCaption, "Inter-Regular.otf", 0.79F, kInterHeight},
    Face{FontRole::kNumber, "JetBrainsMono-SemiBold.ttf", 0.96F, kMonoHeight},
    Face{FontRole::kNumberTable, "JetBrainsMono-Regular.ttf", 0.89F, kMonoHeight},
    Face{FontRole::kNumberSmall, "JetBrainsMono-Regular.ttf", 0.86F, kMonoHeight},
    Face{FontRole::kNumberCaption, "JetBrainsMono-Regular.ttf", 0.79F, kMonoHeight},
    Face{FontRole::kDial, "JetBrainsMono-SemiBold.ttf", 1.57F, kMonoHeight},
    Face{FontRole::kIcon, "MaterialDesignIcons.ttf", 1.29F, kIconHeight},
    Face{FontRole::kIconSmall, "MaterialDesignIcons.ttf", 1.14F, kIconHeight},
};
static_assert(kFaces.size() == static_cast<std::size_t>(FontRole::kCount));

// Latin-1, and beyond it what the window writes: – — … ′ ″ σ Δ Ω μ − ≤ ≥ → ≈ · and thin space.
constexpr ImWchar kText[] = {0x20,   0xFF,   0x394,  0x394,  0x3A9,  0x3A9,  0x3BC,  0x3BC,
                             0x3C3,  0x3C3,  0x2009, 0x2009, 0x2013, 0x2014, 0x2018, 0x201D,
                             0x2026, 0x2026, 0x2032, 0x2033, 0x2190, 0x2193, 0x2212, 0x2212,
                             0x2248, 0x2248, 0x2264, 0x2265, 0};

const ImWchar* icon_ranges() {
    static const std::vector<ImWchar> ranges = [] {
        std::vector<ImWchar> pairs;
        for (const Icon icon : kIcons) {
            pairs.insert(pairs.end(), 2, static_cast<ImWchar>(icon));
        }
        pairs.push_back(0);
        return pairs;
    }();
    return ranges.data();
}

}  // namespace

Result<FontSet> FontSet::bake(ImFontAtlas& atlas, Scale scale) {
    atlas.Clear();
    atlas.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
    FontSet set;
    for (const Face& face : kFaces) {
        const auto path = find_resource(std::string("assets/fonts/") + face.file);
        if (!path) return forward_error(path.error());
        const bool icons = face.height == kIconHeight;
        ImFontConfig config;
        // Letters stand between pixels, so that words keep the spacing of their designer.
        config.OversampleH = icons ? 1 : 2;
        config.OversampleV = 1;
        const float em = std::max(6.0F, face.size_em * kTextSizePx * scale.factor());
        ImFont* font = atlas.AddFontFromFileTTF(path->c_str(), em * face.height, &config,
                                                icons ? icon_ranges() : kText);
        if (font == nullptr) return input_error("{} is no font file", path->string());
        const auto index = static_cast<std::size_t>(face.role);
        set.fonts_[index] = font;
        set.em_px_[index] = em;
    }
    // Plain ImGui items (inputs, menus) are written in the text face.
    ImGui::GetIO().FontDefault = set[FontRole::kText];
    if (!atlas.Build()) return device_error("the fonts do not fit into a texture");
    // JetBrains Mono has no thin space, which parts thousands.
    for (const Face& face : kFaces) {
        if (face.height == kMonoHeight) set[face.role]->AddRemapChar(0x2009, ' ');
    }
    return set;
}

}  // namespace gripscan::ui
