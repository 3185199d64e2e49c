#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <tuple>

#include "app/commands.h"
#include "app/console.h"
#include "app/progress_bar.h"
#include "app/threads.h"
#include "app/tool_frame.h"
#include "core/base/units.h"
#include "core/recognition/library_add.h"
#include "core/report/library_json.h"

namespace gripscan::app {
namespace {

struct LibraryOptions {
    std::string library;
    std::string name;
    std::string unit = "m";
    std::string alignment;
    AddRequest add;
};

std::string lineage_text(const Library& library, const LibraryEntry& entry) {
    if (!entry.held) return "-";
    const std::string gripper = entry.held->gripper.empty() ? "?" : entry.held->gripper;
    switch (lineage_of(library, entry)) {
        case Lineage::kCurrent:
            return gripper;
        case Lineage::kStale:
            return gripper + " STALE";
        default:
            return gripper + " MISSING";
    }
}

Result<ExitStatus> list(const LibraryOptions& options, const Context& context) {
    const auto library = open_library(options.library);
    if (!library) return forward_error(library.error());
    if (context.options.json) {
        print_result(library_json(*library));
        return kDone;
    }
    std::string text = fmt::format("{:24} {:8} {:>8} {:>8}  {:22} {}\n", "template", "kind",
                                   "points", "mm", "symmetry", "held by");
    for (const LibraryEntry& e : library->entries) {
        text += fmt::format("{:24} {:8} {:>8} {:>8.1f}  {:22} {}\n", e.name, e.kind, e.points,
                            kMmPerM * (e.bounds.max_m - e.bounds.min_m).norm(), e.symmetry,
                            lineage_text(*library, e));
    }
    if (!context.options.quiet) print_result(text);
    return kDone;
}

Result<ExitStatus> show(const LibraryOptions& options, const Context& context) {
    const auto library = open_library(options.library);
    if (!library) return forward_error(library.error());
    const LibraryEntry* entry = library->find(options.name);
    if (entry == nullptr) {
        return input_error("the library {} has no template '{}'", options.library, options.name);
    }
    if (context.options.json) {
        print_result(library_entry_json(*library, *entry));
    } else if (!context.options.quiet) {
        print_result(sidecar_text(*entry));
    }
    return kDone;
}

Result<ExitStatus> add(const LibraryOptions& options, const Context& context) {
    auto library = open_or_begin_library(options.library);
    if (!library) return forward_error(library.error());
    AddRequest request = options.add;
    request.name = options.name;
    request.metres_per_unit = options.unit == "mm" ? 0.001 : 1.0;
    request.software = GRIPSCAN_VERSION;
    if (!options.alignment.empty()) {
        const auto T = tool_frame(request.source, options.alignment);
        if (!T) return forward_error(T.error());
        request.T_tool_template = *T;
    }
    WorkerPool pool(thread_count(context));
    ProgressBar bar(context);
    const auto added = add_to_library(*library, request, bar.progress(), pool.for_each());
    if (!added) return forward_error(added.error());
    if (context.options.json) {
        print_result(library_entry_json(*library, added->entry));
    } else if (!context.options.quiet) {
        print_result(fmt::format("{}: {} points, symmetry {}\n", added->entry.name,
                                 added->entry.points, added->entry.symmetry));
    }
    if (!added->same_shape_as.empty()) {
        say(context, fmt::format("it has the same shape as '{}'", added->same_shape_as));
    }
    return kDone;
}

Result<ExitStatus> remove(const LibraryOptions& options, const Context& context) {
    auto library = open_library(options.library);
    if (!library) return forward_error(library.error());
    if (Status removed = remove_entry(*library, options.name); !removed) {
        return forward_error(removed.error());
    }
    if (context.options.json) print_result(library_json(*library));
    return kDone;
}

using Command = Result<ExitStatus> (*)(const LibraryOptions&, const Context&);

CLI::App* add_part(const CommandLine& line, CLI::App& group, const char* name, const char* what,
                   Command run, const std::shared_ptr<LibraryOptions>& options) {
    CLI::App* command = group.add_subcommand(name, what);
    command->add_option("library", options->library, "The library's folder")
        ->required()
        ->option_text("DIR");
    add_common_options(*command, line.common);
    command->callback([options, run, &action = line.action] {
        action = [options, run](const Context& context) { return run(*options, context); };
    });
    return command;
}

void add_options_of_add(CLI::App& command, LibraryOptions& options) {
    command
        .add_option("source", options.add.source,
                    "A session or results folder, a cloud, or a CAD model (STL, OBJ, PLY)")
        ->required()
        ->option_text("SOURCE");
    command.add_option("--name", options.name, "Of the template (the source's)")
        ->option_text("NAME");
    command.add_option("--kind", options.add.kind, "Of the part (as recorded, else object)")
        ->check(CLI::IsMember({"gripper", "object"}))
        ->option_text("gripper|object");
    command.add_option("--unit", options.unit, "Of the source's coordinates (m)")
        ->check(CLI::IsMember({"m", "mm"}))
        ->option_text("m|mm");
    command
        .add_option("--alignment", options.alignment,
                    "Of a gripper's session: T_robot_camera; tells how the template sits on the "
                    "flange, for grasps")
        ->option_text("FILE");
    command.add_flag("--replace", options.add.replace, "Replace the template of that name");
    command.add_flag("--duplicate", options.add.allow_duplicate,
                     "Even if the same points or the same shape are there under another name");
}

}  // namespace

void add_library(const CommandLine& line) {
    CLI::App* group = line.app.add_subcommand("library", "Templates kept for recognition");
    auto options = std::make_shared<LibraryOptions>();
    add_part(line, *group, "list", "What is in it, and which templates are stale", list, options);
    CLI::App* adding =
        add_part(line, *group, "add", "Add a measured template or a CAD model", add, options);
    add_options_of_add(*adding, *options);
    for (const auto& [name, what, run] :
         {std::tuple{"remove", "Remove a template", &remove},
          std::tuple{"show", "Everything known of a template", &show}}) {
        add_part(line, *group, name, what, run, options)
            ->add_option("name", options->name, "Of the template")
            ->required()
            ->option_text("NAME");
    }
    need_subcommand(*group);
}

}  // namespace gripscan::app
