// The icons of the window: places in assets/fonts/MaterialDesignIcons.ttf.
#pragma once

#include <array>

namespace gripscan::ui {

enum class Icon : unsigned {
    kNone = 0,
    kBack = 0xF54D,
    kBell = 0xF09C,
    kCamera = 0xF100,
    kChart = 0xF12A,
    kCheck = 0xF12C,
    kChevronDown = 0xF140,
    kChevronRight = 0xF142,
    kClose = 0xF156,
    kCompare = 0xF18A,
    kCopy = 0xF18F,
    kCrop = 0xF19E,
    kCursor = 0xF1A4,
    kCube = 0xF1A7,
    kDownload = 0xF1DA,
    kExport = 0xF207,
    kFilter = 0xF233,
    kFlash = 0xF241,
    kFlask = 0xF096,
    kFolder = 0xF256,
    kFullscreen = 0xF293,
    kHelp = 0xF625,
    kHistory = 0xF2DA,
    kFit = 0xF2F1,
    kImages = 0xF2F9,
    kInformation = 0xF2FD,
    kLightbulb = 0xF336,
    kLink = 0xF339,
    kMagnify = 0xF349,
    kPause = 0xF3E4,
    kPlay = 0xF40A,
    kPlus = 0xF415,
    kRedo = 0xF44E,
    kRetry = 0xF450,
    kProcedure = 0xF464,
    kRotateLeft = 0xF465,
    kStep = 0xF467,
    kRuler = 0xF46D,
    kSchool = 0xF474,
    kSettings = 0xF493,
    kStop = 0xF4DB,
    kTable = 0xF4EB,
    kTarget = 0xF4FE,
    kTheme = 0xF50E,
    kUndo = 0xF54C,
};

/// Every icon but kNone.
inline constexpr std::array kIcons{
    Icon::kBack,        Icon::kBell,         Icon::kCamera,  Icon::kChart,     Icon::kCheck,
    Icon::kChevronDown, Icon::kChevronRight, Icon::kClose,   Icon::kCompare,   Icon::kCopy,
    Icon::kCrop,        Icon::kCursor,       Icon::kCube,    Icon::kDownload,  Icon::kExport,
    Icon::kFilter,      Icon::kFlash,        Icon::kFlask,   Icon::kFolder,    Icon::kFullscreen,
    Icon::kHelp,        Icon::kHistory,      Icon::kFit,     Icon::kImages,    Icon::kInformation,
    Icon::kLightbulb,   Icon::kLink,         Icon::kMagnify, Icon::kPause,     Icon::kPlay,
    Icon::kPlus,        Icon::kRedo,         Icon::kRetry,   Icon::kProcedure, Icon::kRotateLeft,
    Icon::kStep,        Icon::kRuler,        Icon::kSchool,  Icon::kSettings,  Icon::kStop,
    Icon::kTable,       Icon::kTarget,       Icon::kTheme,   Icon::kUndo};

}  // namespace gripscan::ui
