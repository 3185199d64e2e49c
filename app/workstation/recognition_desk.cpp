#include "app/workstation/recognition_desk.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/concurrency/worker_pool.h"
#include "core/scene/scene_survey.h"

namespace gripscan::app {
namespace {
namespace fs = std::filesystem;

constexpr const char* kListing = "Reading the library";
constexpr const char* kSearching = "Recognising";
constexpr const char* kAdding = "Adding to the library";

ui::TemplateKind kind_of(const std::string& kind) {
    return kind == "gripper" ? ui::TemplateKind::kGripper : ui::TemplateKind::kObject;
}

ui::LibraryEntry shown_entry(const Library& library, const LibraryEntry& entry) {
    ui::LibraryEntry shown;
    shown.name = entry.name;
    shown.kind = kind_of(entry.kind);
    shown.points = entry.points;
    shown.symmetry = entry.symmetry;
    if (!entry.held) return shown;
    shown.lineage = fmt::format("held by {}", entry.held->gripper);
    const Lineage lineage = lineage_of(library, entry);
    if (lineage == Lineage::kStale) {
        shown.stale =
            fmt::format("{} was registered with another template of {}: register it again",
                        entry.name, entry.held->gripper);
    } else if (lineage == Lineage::kMissing) {
        shown.stale = fmt::format("the gripper that held {} is not in the library", entry.name);
    }
    return shown;
}

/// Joint 6, from where the gripper's template has turned to.
std::optional<double> joint6_shown(const Library& library, const Detection& d,
                                   const SearchRequest& request) {
    const LibraryEntry* entry = library.find(d.name);
    std::error_code code;
    const bool own = entry != nullptr && entry->kind == "gripper" && entry->T_axis_template &&
                     request.first_joint6_rad && !request.session.empty() &&
                     fs::equivalent(entry->source, request.session, code);
    if (!own) return std::nullopt;
    const Eigen::Vector3d axis = entry->T_axis_template->linear().transpose().col(2);
    const Eigen::AngleAxisd turn(d.T_camera_template.linear());
    return *request.first_joint6_rad + turn.angle() * turn.axis().dot(axis);
}

ui::FoundTemplate shown_template(const Library& library, const PlacedDetection& placed,
                                 const Cloud& scene) {
    const Detection& d = placed.detection;
    ui::FoundTemplate found;
    found.name = d.name;
    found.T_camera_template = d.T_camera_template;
    found.T_robot_template = placed.T_robot_template;
    found.T_gripper_template = placed.T_gripper_template;
    found.score = d.score;
    found.support = d.agreement.support();
    found.found = d.agreement.found();
    found.outline = d.agreement.outline();
    found.rms_m = d.rms_m;
    found.tolerance_m = d.tolerance_m;
    found.explained = d.explained();
    found.symmetry = d.symmetry;
    if (!d.alternatives.empty()) found.next_score = d.alternatives.front().score;
    if (const LibraryEntry* entry = library.find(d.name)) {
        found.kind = kind_of(entry->kind);
        found.box = entry->bounds;
    }
    const std::vector<std::size_t> indices(d.points.begin(), d.points.end());
    found.matched = std::make_shared<Cloud>(select(scene, indices));
    return found;
}

/// The points that no detection claims.
std::shared_ptr<const Cloud> rest_of(const Cloud& scene,
                                     const std::vector<PlacedDetection>& placed) {
    std::vector<bool> taken(scene.size());
    for (const PlacedDetection& p : placed) {
        for (const std::uint32_t i : p.detection.points) taken[i] = true;
    }
    std::vector<std::size_t> rest;
    for (std::size_t i = 0; i < taken.size(); ++i) {
        if (!taken[i]) rest.push_back(i);
    }
    return std::make_shared<Cloud>(select(scene, rest));
}

/// What is in the way, and whether the environment has moved; nothing where it was not learned.
std::vector<std::string> strangers_in(const SearchedView& view, const SearchRequest& request,
                                      const std::vector<LoadedTemplate>& templates,
                                      const std::vector<Detection>& found, const Progress& progress,
                                      const ForEach& for_each) {
    if (!request.environment || !view.cloud.organised()) return {};
    std::vector<Cloud> clouds;
    for (const Detection& d : found) {
        Cloud cloud;
        cloud.points = templates[d.template_index].model->dense.points;
        clouds.push_back(std::move(cloud));
    }
    std::vector<KnownThing> things;
    for (std::size_t i = 0; i < found.size(); ++i) {
        things.push_back({&clouds[i], found[i].T_camera_template});
    }
    SceneKnowledge knowledge;
    knowledge.region = request.region;
    knowledge.things = things;
    if (request.T_robot_camera && view.joints_rad) {
        knowledge.arm.emplace(*view.joints_rad, *request.T_robot_camera);
    }
    const auto survey =
        survey_scene(*request.environment, view.cloud, knowledge, {}, progress, for_each);
    if (!survey) return {survey.error().message};
    std::vector<std::string> strangers;
    if (survey->shift.moved) strangers.push_back(sentence(survey->shift));
    for (const LeftOver& thing : survey->left_overs) strangers.push_back(sentence(thing));
    return strangers;
}

std::optional<ui::ShownGrasp> grasp_of(const std::vector<PlacedDetection>& placed) {
    const auto with_grasp =
        std::ranges::find_if(placed, [](const PlacedDetection& p) { return p.grasp.has_value(); });
    if (with_grasp == placed.end()) return std::nullopt;
    const GraspPose& grasp = *with_grasp->grasp;
    return ui::ShownGrasp{with_grasp->detection.name, grasp.T_robot_tool, grasp.reach.reachable,
                          grasp.reach.sentence};
}

}  // namespace

struct RecognitionDesk::Prepared {
    std::map<std::string, LoadedTemplate> by_check;

    /// Every template of the library, made ready now or before.
    Result<std::vector<LoadedTemplate>> of(const Library& library, const Progress& progress,
                                           const ForEach& for_each) {
        std::vector<LoadedTemplate> all;
        for (const LibraryEntry& entry : library.entries) {
            progress.tell("preparing templates", all.size(), library.entries.size());
            const std::string key = entry.name + entry.check;
            auto known = by_check.find(key);
            if (known == by_check.end()) {
                auto made = prepare_template(library, entry, progress, for_each);
                if (!made) return forward_error(made.error());
                known = by_check.emplace(key, std::move(*made)).first;
            }
            // The sidecar may have changed though the points have not.
            known->second.held = entry.held;
            known->second.T_tool_template = entry.T_tool_template;
            all.push_back(known->second);
        }
        if (all.empty()) {
            return input_error("the library {} holds no templates; add one first",
                               library.folder.string());
        }
        return all;
    }
};

RecognitionDesk::RecognitionDesk(fs::path library, unsigned threads, JobList& jobs, Fail fail)
    : folder_(std::move(library)),
      threads_(threads),
      jobs_(jobs),
      fail_(std::move(fail)),
      prepared_(std::make_shared<Prepared>()) {}

void RecognitionDesk::listed(const Library& library) {
    shown_library_.clear();
    for (const LibraryEntry& entry : library.entries) {
        shown_library_.push_back(shown_entry(library, entry));
    }
}

void RecognitionDesk::refresh() {
    jobs_.start(kListing, [this, folder = folder_](const Progress&) -> JobList::Outcome {
        auto library = std::make_shared<Result<Library>>(open_or_begin_library(folder));
        return [this, library] {
            if (*library) {
                listed(**library);
            } else {
                fail_("The library cannot be read", library->error());
            }
        };
    });
}

void RecognitionDesk::recognise(SearchRequest request) {
    jobs_.start(kSearching,
                [this, request = std::move(request), folder = folder_, threads = threads_,
                 prepared = prepared_](const Progress& progress) -> JobList::Outcome {
                    const auto search = [&]() -> Result<std::shared_ptr<ui::ShownRecognition>> {
                        WorkerPool pool(threads);
                        const auto library = open_or_begin_library(folder);
                        if (!library) return forward_error(library.error());
                        const auto templates = prepared->of(*library, progress, pool.for_each());
                        if (!templates) return forward_error(templates.error());
                        const auto view = request.view(progress, pool.for_each());
                        if (!view) return forward_error(view.error());
                        const auto searching = std::chrono::steady_clock::now();
                        const RecogniseSettings settings;
                        const auto found = gripscan::recognise(models_of(*templates), view->cloud,
                                                               settings, progress, pool.for_each());
                        if (!found) return forward_error(found.error());
                        const std::chrono::duration<double> took =
                            std::chrono::steady_clock::now() - searching;
                        const auto placed =
                            placed_detections(*templates, *found, request.capture.value_or(0),
                                              {request.T_robot_camera, view->joints_rad});
                        auto shown = std::make_shared<ui::ShownRecognition>();
                        shown->capture = request.capture;
                        shown->when = std::chrono::system_clock::now();
                        shown->seconds = took.count();
                        shown->looked_for = templates->size();
                        shown->least_score = settings.least_score;
                        shown->least_found = settings.least_found;
                        for (const PlacedDetection& p : placed) {
                            shown->found.push_back(shown_template(*library, p, view->cloud));
                            const auto joint6 = joint6_shown(*library, p.detection, request);
                            if (joint6 && view->joints_rad) {
                                shown->joint6_gripper_rad = joint6;
                                shown->joint6_robot_rad = (*view->joints_rad)[5];
                            }
                        }
                        shown->strangers = strangers_in(*view, request, *templates, *found,
                                                        progress, pool.for_each());
                        shown->rest = rest_of(view->cloud, placed);
                        shown->picture = view->picture;
                        shown->grasp = grasp_of(placed);
                        return shown;
                    };
                    auto result =
                        std::make_shared<Result<std::shared_ptr<ui::ShownRecognition>>>(search());
                    return [this, result] {
                        if (!*result) {
                            if (result->error().kind != ErrorKind::kCancelled) {
                                fail_("Nothing was recognised", result->error());
                            }
                            return;
                        }
                        (**result)->view = ++views_;
                        (**result)->generation = ++generation_;
                        recognition_ = **result;
                    };
                });
}

void RecognitionDesk::add(const fs::path& session, const std::optional<Pose>& T_tool_template,
                          std::function<void(const std::string& name)> done) {
    jobs_.start(kAdding,
                [this, session, T_tool_template, done = std::move(done), folder = folder_,
                 threads = threads_](const Progress& progress) -> JobList::Outcome {
                    const auto work = [&]() -> Result<std::pair<Library, std::string>> {
                        auto library = open_or_begin_library(folder);
                        if (!library) return forward_error(library.error());
                        AddRequest request;
                        request.source = session;
                        request.T_tool_template = T_tool_template;
                        request.replace = true;  // the same session, computed again
                        request.software = GRIPSCAN_VERSION;
                        WorkerPool pool(threads);
                        const auto added =
                            add_to_library(*library, request, progress, pool.for_each());
                        if (!added) return forward_error(added.error());
                        return std::pair{std::move(*library), added->entry.name};
                    };
                    auto result = std::make_shared<Result<std::pair<Library, std::string>>>(work());
                    return [this, result, done] {
                        if (!*result) {
                            fail_("The template was not added", result->error());
                            return;
                        }
                        listed((*result)->first);
                        done((*result)->second);
                    };
                });
}

void RecognitionDesk::remove(const std::string& name) {
    auto library = open_or_begin_library(folder_);
    if (library) {
        if (Status removed = remove_entry(*library, name); !removed) {
            fail_("The template was not removed", removed.error());
            return;
        }
        listed(*library);
    } else {
        fail_("The library cannot be read", library.error());
    }
}

void RecognitionDesk::leave_session() {
    jobs_.stop(kSearching);
    recognition_.reset();
}

void RecognitionDesk::show_in(ui::Snapshot& snapshot) const {
    snapshot.library = shown_library_;
    snapshot.recognition = recognition_;
}

}  // namespace gripscan::app
