#include "app/template_input.h"

#include <filesystem>

#include "core/cloud/cloud_file.h"
#include "core/recognition/library.h"

namespace gripscan::app {
namespace fs = std::filesystem;
namespace {

/// A template as a file: what its sidecar, if there is one, says of its kind.
Result<LoadedTemplate> load_file(const fs::path& path, const Progress& progress,
                                 const ForEach& for_each) {
    const auto cloud = load_cloud(path);
    if (!cloud) return forward_error(cloud.error());
    const fs::path sidecar = fs::path(path).replace_extension(".json");
    std::string kind;
    std::error_code code;
    if (fs::exists(sidecar, code)) kind = sidecar_kind(sidecar);
    auto model = make_template_model(path.stem().string(), *cloud, {}, progress, for_each);
    if (!model) {
        if (model.error().kind == ErrorKind::kCancelled) return forward_error(model.error());
        return input_error("{}: {}", path.string(), model.error().message);
    }
    return LoadedTemplate{std::move(*model), kind, std::nullopt, std::nullopt};
}

Result<std::vector<LoadedTemplate>> load_library(const fs::path& folder, const Progress& progress,
                                                 const ForEach& for_each) {
    const auto library = open_library(folder);
    if (!library) return forward_error(library.error());
    std::vector<LoadedTemplate> all;
    for (const LibraryEntry& entry : library->entries) {
        progress.tell("preparing templates", all.size(), library->entries.size());
        auto prepared = prepare_template(*library, entry, progress, for_each);
        if (!prepared) return forward_error(prepared.error());
        all.push_back(std::move(*prepared));
    }
    if (all.empty()) return input_error("the library {} holds no templates", folder.string());
    return all;
}

}  // namespace

void add_template_options(CLI::App& command, TemplateOptions& options) {
    auto* files = command.add_option("--template", options.files, "Templates to look for")
                      ->option_text("PCD...");
    auto* library = command
                        .add_option("--library", options.library,
                                    "All templates of a library (see `gripscan library`)")
                        ->option_text("DIR");
    files->excludes(library);
}

Result<LoadedTemplate> prepare_template(const Library& library, const LibraryEntry& entry,
                                        const Progress& progress, const ForEach& for_each) {
    const auto cloud = load_entry(library, entry);
    if (!cloud) return forward_error(cloud.error());
    auto model = make_template_model(entry.name, *cloud, {}, progress, for_each);
    if (!model) return forward_error(model.error());
    return LoadedTemplate{std::move(*model), entry.kind, entry.held, entry.T_tool_template};
}

Result<std::vector<LoadedTemplate>> load_templates(const TemplateOptions& options,
                                                   const Progress& progress,
                                                   const ForEach& for_each) {
    if (!options.library.empty()) return load_library(options.library, progress, for_each);
    if (options.files.empty()) return input_error("say what to look for: --template or --library");
    std::vector<LoadedTemplate> all;
    for (const std::string& file : options.files) {
        progress.tell("preparing templates", all.size(), options.files.size());
        auto loaded = load_file(file, progress, for_each);
        if (!loaded) return forward_error(loaded.error());
        all.push_back(std::move(*loaded));
    }
    return all;
}

std::vector<std::shared_ptr<const TemplateModel>> models_of(
    const std::vector<LoadedTemplate>& templates) {
    std::vector<std::shared_ptr<const TemplateModel>> models;
    for (const LoadedTemplate& t : templates) models.push_back(t.model);
    return models;
}

}  // namespace gripscan::app
