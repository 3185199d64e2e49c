// The templates a command looks for: files, or a whole library.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/for_each.h"
#include "core/base/progress.h"
#include "core/recognition/library.h"
#include "core/recognition/template_model.h"

namespace gripscan::app {

struct TemplateOptions {
    std::vector<std::string> files;
    std::string library;
};

void add_template_options(CLI::App& command, TemplateOptions& options);

struct LoadedTemplate {
    std::shared_ptr<const TemplateModel> model;
    std::string kind;                     ///< "gripper", "object"; empty: not known
    std::optional<HeldBy> held;           ///< of an object in a library
    std::optional<Pose> T_tool_template;  ///< of a gripper in a library
};

/// One of a library. Errors: points that are not those of the sidecar; cancelled.
[[nodiscard]] Result<LoadedTemplate> prepare_template(const Library& library,
                                                      const LibraryEntry& entry,
                                                      const Progress& progress,
                                                      const ForEach& for_each);

/// Reads and prepares them. Errors: neither or both ways given, files that cannot be read.
[[nodiscard]] Result<std::vector<LoadedTemplate>> load_templates(const TemplateOptions& options,
                                                                 const Progress& progress,
                                                                 const ForEach& for_each);
[[nodiscard]] std::vector<std::shared_ptr<const TemplateModel>> models_of(
    const std::vector<LoadedTemplate>& templates);

}  // namespace gripscan::app
