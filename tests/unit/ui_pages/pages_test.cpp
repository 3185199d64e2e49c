// What the pages and dialogs ask for, driven by mouse and keyboard without a window.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/procedure/cell_check.h"
#include "core/sim/fault_plan.h"
#include "tests/support/sample_pages.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/ui_driver.h"
#include "ui/panels/cell_page.h"
#include "ui/panels/close_dialog.h"
#include "ui/panels/error_dialog.h"
#include "ui/panels/export_dialog.h"
#include "ui/panels/keys_overlay.h"
#include "ui/panels/new_session_dialog.h"
#include "ui/panels/note_dialog.h"
#include "ui/panels/open_dialog.h"
#include "ui/panels/settings_dialog.h"
#include "ui/panels/start_page.h"
#include "ui/panels/template_page.h"
#include "ui/views/cell_view.h"
#include "ui/views/fault_names.h"
#include "ui/views/key_table.h"
#include "ui/views/start_view.h"
#include "ui/views/template_view.h"

namespace gripscan::ui {
namespace {

using test::UiDriver;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr int kWidth = 1400;
constexpr int kHeight = 900;

/// A panel over the whole window, and everything it has asked for.
template <typename State, auto Draw>
struct Panel {
    Snapshot snapshot;
    State local;
    Requests out;
    float scale = 1.0F;
    int width = kWidth;
    int height = kHeight;
    UiDriver driver{width, height, [this](const Ui& ui) {
                        Draw(ui, {0, 0, width, height}, snapshot, local, out);
                    }};

    template <typename T>
    [[nodiscard]] const T* last() const {
        return out.empty() ? nullptr : std::get_if<T>(&out.back());
    }
    template <typename T>
    [[nodiscard]] const T* first() const {
        for (const Request& r : out) {
            if (const T* t = std::get_if<T>(&r)) return t;
        }
        return nullptr;
    }
    [[nodiscard]] bool closes() const {
        const auto* show = last<request::Show>();
        return show != nullptr && show->dialog == Dialog::kNone;
    }
    [[nodiscard]] std::string reason(std::string_view id) const {
        const auto record = driver.log().find(id);
        return record ? record->reason : "not shown";
    }
};

using StartPanel = Panel<StartPageState, draw_start_page>;
using TemplatePanel = Panel<TemplatePageState, draw_template_column>;
using ExportPanel = Panel<ExportDialogState, draw_export_dialog>;
using CellPanel = Panel<CellPageState, draw_cell_page>;
using NewPanel = Panel<NewSessionState, draw_new_session_dialog>;
using OpenPanel = Panel<OpenDialogState, draw_open_dialog>;
using NotePanel = Panel<NoteDialogState, draw_note_dialog>;
using SettingsPanel = Panel<SettingsState, draw_settings_dialog>;
using KeysPanel = Panel<KeysOverlayState, draw_keys_overlay>;
using ErrorPanel = Panel<ErrorDialogState, draw_error_dialog>;
using ClosePanel = Panel<CloseDialogState, draw_close_dialog>;

TEST(StartPage, BeginsTheSimulatedCellWithOneClick) {
    StartPanel p;
    ASSERT_TRUE(p.driver.click("start.simulated"));
    ASSERT_EQ(p.out.size(), 1U);
    ASSERT_NE(p.last<request::Begin>(), nullptr);
    EXPECT_EQ(p.last<request::Begin>()->wish.cell, "sim");
}

TEST(StartPage, TakesItsLettersAndSpace) {
    StartPanel p;
    p.driver.frame();
    p.driver.type("o");
    ASSERT_NE(p.last<request::Show>(), nullptr);
    EXPECT_EQ(p.last<request::Show>()->dialog, Dialog::kOpen);
    p.driver.type("N");
    EXPECT_EQ(p.last<request::Show>()->dialog, Dialog::kNewSession);
    EXPECT_TRUE(p.last<request::Show>()->cell_file);
    p.driver.type("g");
    EXPECT_NE(p.last<request::Tour>(), nullptr);
    p.driver.key(ImGuiKey_Space);
    EXPECT_NE(p.last<request::Begin>(), nullptr);
}

TEST(StartPage, TakesNoKeyWhileADialogIsOpen) {
    StartPanel p;
    p.snapshot.dialog = Dialog::kOpen;
    p.driver.frame();
    p.driver.type("s");
    p.driver.key(ImGuiKey_Space);
    EXPECT_THAT(p.out, IsEmpty());
}

TEST(StartPage, ResumesTheLatestInterruptedSession) {
    StartPanel p;
    p.snapshot.recent = test::sample_recent();
    p.driver.frame();
    p.driver.key(ImGuiKey_Space);
    ASSERT_NE(p.last<request::Resume>(), nullptr);
    EXPECT_EQ(p.last<request::Resume>()->folder, "/sessions/valve-T20");
    ASSERT_TRUE(p.driver.click("start.look"));
    ASSERT_NE(p.last<request::Open>(), nullptr);
    EXPECT_EQ(p.last<request::Open>()->path, "/sessions/valve-T20");
}

TEST(StartPage, OpensWhatIsCompleteAndResumesWhatIsNot) {
    StartPanel p;
    p.snapshot.recent = test::sample_recent();
    ASSERT_TRUE(p.driver.click("recent.row1"));
    ASSERT_NE(p.last<request::Open>(), nullptr);
    EXPECT_EQ(p.last<request::Open>()->path, "/sessions/valve-T18");
    ASSERT_TRUE(p.driver.click("recent.row0"));
    EXPECT_NE(p.last<request::Resume>(), nullptr);
}

TEST(StartPage, ForgetsALineByItsMenu) {
    StartPanel p;
    p.snapshot.recent = test::sample_recent();
    ASSERT_TRUE(p.driver.click("recent.row2", ImGuiMouseButton_Right));
    p.driver.frame();
    ASSERT_TRUE(p.driver.click("recent.forget"));
    ASSERT_NE(p.last<request::Forget>(), nullptr);
    EXPECT_EQ(p.last<request::Forget>()->folder, "/sessions/gripper G2");
}

TEST(StartPage, SearchLeavesThoseThatMatch) {
    StartPanel p;
    p.snapshot.recent = test::sample_recent();
    ASSERT_TRUE(p.driver.click("recent.search"));
    p.driver.type("gripper");  // no letter of it starts anything
    EXPECT_THAT(p.out, IsEmpty());
    p.driver.frame();
    EXPECT_TRUE(p.driver.log().find("recent.row1"));
    EXPECT_FALSE(p.driver.log().find("recent.row2"));
}

TEST(StartView, SearchesEveryWordInEitherCase) {
    const auto recent = test::sample_recent();
    EXPECT_EQ(found(recent, "").size(), recent.size());
    EXPECT_EQ(found(recent, "OBJECT cell-3").size(), 3U);
    EXPECT_EQ(found(recent, "symmetry").size(), 1U);
    EXPECT_THAT(found(recent, "nothing like it"), IsEmpty());
}

TEST(StartView, SaysStepsAndClosure) {
    const auto recent = test::sample_recent();
    EXPECT_EQ(steps_text(recent[0]), "14 / 36");
    EXPECT_EQ(closure_text(recent[0]).angle, "not closed");
    EXPECT_EQ(closure_text(recent[1]).angle, "0.07°");
    EXPECT_EQ(closure_text(recent[1]).shift, "0.24 mm");
    EXPECT_THAT(requests_of_click(recent.back()), IsEmpty());  // its folder is gone
}

void give_template(Snapshot& snapshot) {
    snapshot.shown_template = test::sample_template(snapshot.filter);
}

TEST(TemplateColumn, SaysWhyNothingCanBeDoneWithoutATemplate) {
    TemplatePanel p;
    p.driver.frame();
    for (const char* id : {"crop.x.from", "crop.fit", "crop.invert", "seen.least", "seen.slider",
                           "denoise.statistical", "template.export"}) {
        EXPECT_EQ(p.reason(id), "There is no template yet.") << id;
    }
}

TEST(TemplateColumn, CropsByTypedNumbers) {
    TemplatePanel p;
    give_template(p.snapshot);
    ASSERT_TRUE(p.driver.click("crop.x.from"));
    p.driver.type("-10");
    p.driver.key(ImGuiKey_Enter);
    const auto* wish = p.last<request::SetFilter>();
    ASSERT_NE(wish, nullptr);
    ASSERT_TRUE(wish->filter.crop);
    EXPECT_DOUBLE_EQ(wish->filter.crop->min_m.x(), -0.010);
    // The other sides are those of the whole template.
    EXPECT_DOUBLE_EQ(wish->filter.crop->max_m.z(),
                     p.snapshot.shown_template->whole_facts.bounds->max_m.z());
}

TEST(TemplateColumn, SwitchesDenoisingAndExports) {
    TemplatePanel p;
    give_template(p.snapshot);
    ASSERT_TRUE(p.driver.click("denoise.statistical"));
    ASSERT_NE(p.last<request::SetFilter>(), nullptr);
    EXPECT_DOUBLE_EQ(p.last<request::SetFilter>()->filter.denoise_sigmas, 1.5);
    ASSERT_TRUE(p.driver.click("template.export"));
    ASSERT_NE(p.last<request::Show>(), nullptr);
    EXPECT_EQ(p.last<request::Show>()->dialog, Dialog::kExport);
}

TEST(TemplateColumn, AFilterThatKeepsNothingCannotBeExported) {
    TemplatePanel p;
    p.snapshot.filter.min_seen = 1000;
    give_template(p.snapshot);
    p.driver.frame();
    EXPECT_EQ(p.reason("template.export"), "The filter keeps no point.");
}

TEST(TemplateView, SidesOfTheCuboidNeverCross) {
    Snapshot snapshot;
    snapshot.filter.crop = Box{{0, 0, 0}, {0.1, 0.1, 0.1}};
    for (const double mm : {-500.0, 0.0, 50.0, 100.0, 500.0}) {
        for (const CropSide side : {CropSide::kFrom, CropSide::kTo}) {
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_TRUE(with_crop_side(snapshot, axis, side, mm).crop->valid()) << mm;
            }
        }
    }
    const Box sized = *with_crop_side(snapshot, 1, CropSide::kSize, 40.0).crop;
    EXPECT_NEAR(sized.max_m.y() - sized.min_m.y(), 0.040, 1e-12);
    EXPECT_NEAR(sized.max_m.y() + sized.min_m.y(), 0.1, 1e-12);  // about its middle
}

TEST(TemplateView, FittingKeepsEveryPointThatWasKept) {
    Snapshot snapshot;
    snapshot.filter.min_seen = 12;
    give_template(snapshot);
    const auto before = snapshot.shown_template->counts.kept;
    snapshot.filter = fitted_crop(snapshot);
    give_template(snapshot);
    EXPECT_EQ(snapshot.shown_template->counts.kept, before);
    snapshot.filter.invert_crop = true;
    EXPECT_FALSE(why_no_fit(snapshot).empty());
}

TEST(ExportDialog, NeverOverwrites) {
    const test::TemporaryFolder folder;
    ExportPanel p;
    p.snapshot.session.emplace();
    p.snapshot.session->folder = folder.path();
    p.snapshot.session->name = "part";
    give_template(p.snapshot);
    test::write_text(folder / "exports/part_v1.pcd", "taken");
    p.driver.frame();
    EXPECT_EQ(p.local.wish.file, folder / "exports/part_v2.pcd");
    p.local.wish.file = folder / "exports/part_v1.pcd";
    p.driver.frame();
    EXPECT_THAT(p.reason("export.write"), HasSubstr("nothing is overwritten"));
    ASSERT_TRUE(p.driver.click("export.write"));
    EXPECT_THAT(p.out, IsEmpty());
}

TEST(ExportDialog, AsksForWhatWasChosen) {
    const test::TemporaryFolder folder;
    ExportPanel p;
    p.snapshot.session.emplace();
    p.snapshot.session->folder = folder.path();
    p.snapshot.filter.min_seen = 3;
    give_template(p.snapshot);
    ASSERT_TRUE(p.driver.click("export.ply"));
    ASSERT_TRUE(p.driver.click("export.mm"));
    ASSERT_TRUE(p.driver.click("export.normals"));
    p.driver.frame();
    EXPECT_FALSE(p.reason("export.compressed").empty());
    EXPECT_FALSE(p.reason("export.axis").empty());  // no axis is known
    EXPECT_FALSE(p.reason("export.intensity").empty());
    ASSERT_TRUE(p.driver.click("export.write"));
    const auto* wish = p.first<request::Export>();
    ASSERT_NE(wish, nullptr);
    EXPECT_EQ(wish->wish.file.extension(), ".ply");
    EXPECT_EQ(wish->wish.encoding, PcdEncoding::kBinary);
    EXPECT_TRUE(wish->wish.millimetres);
    EXPECT_FALSE(wish->wish.normals);
    EXPECT_EQ(wish->wish.filter.min_seen, 3);
    EXPECT_TRUE(p.closes());
}

TEST(CellPage, ChecksAndAcceptsWithANote) {
    const ProcedureState failed = test::sample_cell_state(test::SampleCell::kFailed);
    CellPanel p;
    p.snapshot.procedure = &failed;
    ASSERT_TRUE(p.driver.click("cell.check"));
    const auto* give = p.last<request::Give>();
    ASSERT_NE(give, nullptr);
    EXPECT_TRUE(std::holds_alternative<command::CheckCell>(give->command));
    ASSERT_TRUE(p.driver.click("cell.accept"));
    ASSERT_NE(p.last<request::Show>(), nullptr);
    EXPECT_EQ(p.last<request::Show>()->dialog, Dialog::kNote);
}

TEST(CellPage, OffersNoAcceptWhereNothingFailed) {
    const ProcedureState passed = test::sample_cell_state(test::SampleCell::kPassed);
    CellPanel p;
    p.snapshot.procedure = &passed;
    p.driver.frame();
    EXPECT_FALSE(p.driver.log().find("cell.accept"));
}

TEST(CellPage, LimitsAreEditedBeforeTheFirstViewOnly) {
    ProcedureState state = test::sample_cell_state(test::SampleCell::kPassed);
    CellPanel p;
    p.snapshot.procedure = &state;
    ASSERT_TRUE(p.driver.click("plan.angle"));
    p.driver.type("0.25");
    p.driver.key(ImGuiKey_Enter);
    const auto* set = p.last<request::SetPlan>();
    ASSERT_NE(set, nullptr);
    EXPECT_NEAR(deg_from_rad(set->plan.limits.angle_rad), 0.25, 1e-12);
    EXPECT_EQ(set->plan.limits.sigmas, state.plan.limits.sigmas);
    state.plan = set->plan;
    ASSERT_TRUE(p.driver.click("plan.angle.reset"));
    EXPECT_NEAR(deg_from_rad(p.last<request::SetPlan>()->plan.limits.angle_rad), 0.5, 1e-9);
    state.data.captures.resize(1);
    p.driver.frame();
    EXPECT_THAT(p.reason("plan.angle"), HasSubstr("first view is taken"));
}

/// A session of a cell file, before its first view.
void open_cell_file(Snapshot& snapshot, const ProcedureState& state) {
    snapshot.procedure = &state;
    snapshot.session.emplace();
    snapshot.cell.file = "/cells/cell.yaml";
    snapshot.cell.rig.emplace();
    snapshot.cell.region = Box{{-0.1, -0.1, 0.6}, {0.1, 0.1, 0.8}};
}

TEST(CellPage, TheRegistrationAreaIsEditedForTheNextSession) {
    ProcedureState state = test::sample_cell_state(test::SampleCell::kPassed);
    CellPanel p;
    open_cell_file(p.snapshot, state);
    ASSERT_TRUE(p.driver.click("region.x.to"));
    p.driver.type("150");
    p.driver.key(ImGuiKey_Enter);
    const auto* set = p.last<request::SetRegion>();
    ASSERT_NE(set, nullptr);
    ASSERT_TRUE(set->region);
    EXPECT_NEAR(set->region->max_m.x(), 0.150, 1e-12);
    EXPECT_EQ(set->region->min_m, p.snapshot.cell.region->min_m);
    EXPECT_EQ(p.reason("region.keep"), "Nothing was changed.");
    p.snapshot.cell.wished_region = set->region;
    ASSERT_TRUE(p.driver.click("region.keep"));
    EXPECT_NE(p.last<request::KeepRegion>(), nullptr);
    ASSERT_TRUE(p.driver.click("region.reset"));
    ASSERT_NE(p.last<request::SetRegion>(), nullptr);
    EXPECT_FALSE(p.last<request::SetRegion>()->region);
}

TEST(CellView, TheRegistrationAreaStaysWhereItIsNotForTheOperatorToChange) {
    ProcedureState state = test::sample_cell_state(test::SampleCell::kPassed);
    Snapshot snapshot;
    open_cell_file(snapshot, state);
    EXPECT_EQ(why_region_is_fixed(snapshot), "");
    snapshot.session->recorded = true;
    EXPECT_THAT(why_region_is_fixed(snapshot), HasSubstr("recording"));
    snapshot.session->recorded = false;
    state.data.captures.resize(1);
    EXPECT_THAT(why_region_is_fixed(snapshot), HasSubstr("first view is taken"));
    state.data.captures.clear();
    snapshot.cell.file.clear();
    EXPECT_THAT(why_region_is_fixed(snapshot), HasSubstr("simulated cell"));
}

TEST(CellView, EndsOfTheRegistrationAreaNeverMeet) {
    const Box region{{0, 0, 0.5}, {0.1, 0.1, 0.7}};
    for (const double value_m : {-0.5, 0.0, 0.05, 0.6, 2.0}) {
        for (int axis = 0; axis < 3; ++axis) {
            for (const bool upper : {false, true}) {
                const Box changed = with_region_end(region, axis, upper, value_m);
                EXPECT_TRUE(changed.valid());
                EXPECT_EQ((upper ? changed.max_m : changed.min_m)[axis], value_m);
            }
        }
    }
}

TEST(CellView, EveryLimitOfTheCheckSaysOnWhichSideOfItTheValueHasToLie) {
    CellReport all = assess(CellFacts{}, TurnPlan{});
    ASSERT_GT(all.items.size(), 15U);
    for (CellCheckItem& item : all.items) {
        item.outcome = CheckOutcome::kPassed;
        item.limit = 40.0;
        EXPECT_TRUE(limit_text(item) == "≤ 40" || limit_text(item) == "≥ 40") << item.name;
    }
    // As the check itself takes it: what passed lies on the right side, what failed does not.
    for (const auto sample : {test::SampleCell::kPassed, test::SampleCell::kFailed}) {
        const ProcedureState state = test::sample_cell_state(sample);
        for (const CellCheckItem& item : state.cell->items) {
            if (item.outcome == CheckOutcome::kSkipped) continue;
            const bool at_most = limit_text(item).starts_with("≤");
            const bool inside = at_most ? item.value <= item.limit : item.value >= item.limit;
            if (item.outcome == CheckOutcome::kPassed) {
                EXPECT_TRUE(inside) << item.name;
            }
            if (item.outcome == CheckOutcome::kFailed) {
                EXPECT_FALSE(inside) << item.name;
            }
        }
    }
    CellCheckItem joint{"joint", CheckOutcome::kPassed, 80.0, 40.0, "mm", ""};
    EXPECT_EQ(limit_text(joint), "≥ 40");
    joint.unit = "mm²";
    EXPECT_EQ(limit_text(joint), "≤ 40") << "without an alignment it is an area";
}

TEST(CellView, EveryFieldOfThePlanSetsItselfAlone) {
    for (std::size_t i = 0; i < kPlanFields; ++i) {
        const auto before = plan_fields(TurnPlan{});
        const double value = before[i].min + 0.25 * (before[i].max - before[i].min);
        const auto after = plan_fields(with_plan_field(TurnPlan{}, i, value));
        for (std::size_t k = 0; k < kPlanFields; ++k) {
            EXPECT_NEAR(after[k].value, k == i ? value : before[k].value, 1e-8) << i << ' ' << k;
            EXPECT_EQ(after[k].changed(), k == i) << i << ' ' << k;
        }
    }
}

TEST(NewSession, BeginsTheSimulationWithItsFaults) {
    NewPanel p;
    ASSERT_TRUE(p.driver.click("new.fault.slip"));
    ASSERT_TRUE(p.driver.click("new.fault.glare"));
    ASSERT_TRUE(p.driver.click("new.fault.slip"));
    ASSERT_TRUE(p.driver.click("new.begin"));
    const auto* begin = p.first<request::Begin>();
    ASSERT_NE(begin, nullptr);
    EXPECT_THAT(begin->wish.faults, ElementsAre("glare"));
    EXPECT_TRUE(p.closes());
}

TEST(NewSession, LiveNeedsACellFileAndNeverLeaksIntoTheSimulation) {
    const test::TemporaryFolder folder;
    NewPanel p;
    p.local.typed.simulated = false;
    p.driver.frame();
    EXPECT_FALSE(p.reason("new.begin").empty());
    test::write_text(folder / "cell.yaml", "format: gripscan-cell/1\n");
    p.local.typed.cell_file = (folder / "cell.yaml").string();
    ASSERT_TRUE(p.driver.click("new.live"));
    ASSERT_TRUE(p.driver.click("new.begin"));
    ASSERT_NE(p.first<request::Begin>(), nullptr);
    EXPECT_TRUE(p.first<request::Begin>()->wish.live);
    p.out.clear();
    ASSERT_TRUE(p.driver.click("new.simulated"));
    ASSERT_TRUE(p.driver.click("new.begin"));
    ASSERT_NE(p.first<request::Begin>(), nullptr);
    EXPECT_FALSE(p.first<request::Begin>()->wish.live);
    EXPECT_EQ(p.first<request::Begin>()->wish.cell, "sim");
}

TEST(NewSession, RefusesAFolderThatHoldsSomething) {
    const test::TemporaryFolder folder;
    test::write_text(folder / "old/file", "x");
    NewPanel p;
    p.local.typed.folder = (folder / "old").string();
    p.driver.frame();
    EXPECT_THAT(p.reason("new.begin"), HasSubstr("never overwritten"));
}

TEST(FaultNames, AreThoseOfTheSimulation) {
    std::vector<std::string_view> ours;
    std::vector<std::string_view> theirs;
    for (const FaultName& f : fault_names()) ours.push_back(f.name);
    for (const sim::FaultInfo& f : sim::fault_table()) theirs.push_back(f.name);
    std::sort(ours.begin(), ours.end());
    std::sort(theirs.begin(), theirs.end());
    EXPECT_EQ(ours, theirs);
    EXPECT_THAT(toggled({"slip@7=1", "glare"}, "slip"), ElementsAre("glare"));
}

TEST(OpenDialog, OpensOnEnterWhatIsThere) {
    const test::TemporaryFolder folder;
    test::write_text(folder / "monday/session.yaml", "x");
    OpenPanel p;
    p.local.path = (folder / "mon").string();
    p.driver.frame();
    EXPECT_FALSE(p.reason("open.open").empty());
    ASSERT_EQ(p.local.listing.entries.size(), 1U);
    ASSERT_TRUE(p.driver.click("open.entry0"));
    p.driver.frame();
    EXPECT_EQ(p.local.path, (folder / "monday").string());
    p.driver.key(ImGuiKey_Enter);
    const auto* open = p.first<request::Open>();
    ASSERT_NE(open, nullptr);
    EXPECT_EQ(open->path, folder / "monday");
    EXPECT_TRUE(p.closes());
}

TEST(PathListing, ShowsSessionsFirstAndNothingOfNoUse) {
    const test::TemporaryFolder folder;
    test::write_text(folder / "b/session.yaml", "x");
    std::filesystem::create_directories(folder / "a");
    test::write_text(folder / "c.PCD", "x");
    test::write_text(folder / "notes.txt", "x");
    test::write_text(folder / ".hidden/x", "x");
    const PathListing listing = list_paths(folder.path().string() + "/");
    std::vector<std::string> names;
    for (const PathEntry& e : listing.entries) names.push_back(e.name);
    EXPECT_THAT(names, ElementsAre("b", "a", "c.PCD"));
    EXPECT_FALSE(list_paths((folder / "none/").string()).problem.empty());
    EXPECT_TRUE(list_paths(folder.path().string() + "/", 2).cut);
}

TEST(NoteDialog, WantsANoteThatIsNotBlank) {
    const ProcedureState failed = test::sample_cell_state(test::SampleCell::kFailed);
    NotePanel p;
    p.snapshot.procedure = &failed;
    p.driver.frame();
    p.driver.frame();
    EXPECT_FALSE(p.reason("note.accept").empty());
    p.driver.type("   ");
    p.driver.key(ImGuiKey_Enter);
    EXPECT_EQ(p.first<request::Give>(), nullptr);
    ASSERT_TRUE(p.driver.click("note.text"));
    p.driver.type("lamp is warm now");
    p.driver.key(ImGuiKey_Enter);
    const auto* give = p.first<request::Give>();
    ASSERT_NE(give, nullptr);
    EXPECT_THAT(std::get<command::Accept>(give->command).note, HasSubstr("lamp is warm now"));
    EXPECT_TRUE(p.closes());
}

TEST(SettingsDialog, AsksForLooksAndTakesNewKeys) {
    SettingsPanel p;
    p.snapshot.keys = test::sample_keys();
    ASSERT_TRUE(p.driver.click("settings.light"));
    ASSERT_NE(p.last<request::SetTheme>(), nullptr);
    EXPECT_EQ(p.last<request::SetTheme>()->theme, ThemeChoice::kLight);
    ASSERT_TRUE(p.driver.click("settings.scale150"));
    ASSERT_NE(p.last<request::SetScale>(), nullptr);
    EXPECT_DOUBLE_EQ(p.last<request::SetScale>()->factor, 1.5);
    ASSERT_TRUE(p.driver.click("settings.large"));
    ASSERT_NE(p.last<request::SetLargeButtons>(), nullptr);
    ASSERT_TRUE(p.driver.click("settings.layout"));
    ASSERT_NE(p.last<request::ResetLayout>(), nullptr);
    ASSERT_TRUE(p.driver.click("settings.keys"));
    ASSERT_TRUE(p.driver.click("settings.key.step.retry"));
    p.driver.key(ImGuiKey_Home);
    const auto* set = p.last<request::SetKey>();
    ASSERT_NE(set, nullptr);
    EXPECT_EQ(set->action, "step.retry");
    EXPECT_EQ(set->key, "Home");
}

TEST(SettingsDialog, EscapeTakesTheQuestionForAKeyBackAndThenCloses) {
    SettingsPanel p;
    p.snapshot.keys = test::sample_keys();
    p.local.tab = 1;
    ASSERT_TRUE(p.driver.click("settings.key.step.retry"));
    p.driver.key(ImGuiKey_Escape);
    EXPECT_THAT(p.out, IsEmpty());
    p.driver.key(ImGuiKey_Escape);
    EXPECT_TRUE(p.closes());
}

TEST(KeyTable, RefusesKeysThatAreTaken) {
    const auto keys = test::sample_keys();
    EXPECT_THAT(key_problem(keys, "step.retry", "C"), HasSubstr("Capture"));
    EXPECT_EQ(key_problem(keys, "step.retry", "R"), "");
    EXPECT_FALSE(key_problem(keys, "step.retry", "Esc").empty());
    EXPECT_EQ(key_groups(keys, "ctrl").size(), 2U);
}

TEST(ErrorDialog, OffersOneActionAndCopies) {
    ErrorPanel p;
    p.snapshot.error = ShownError{
        "Lost", "No answer.", "Look.", "Connect again", {request::Give{command::Connect{}}}};
    ASSERT_TRUE(p.driver.click("error.copy"));
    ASSERT_NE(p.last<request::CopyText>(), nullptr);
    EXPECT_EQ(p.last<request::CopyText>()->text, "Lost\nNo answer.\nLook.");
    p.driver.key(ImGuiKey_Enter);
    ASSERT_NE(p.last<request::Give>(), nullptr);
    EXPECT_TRUE(std::holds_alternative<command::Connect>(p.last<request::Give>()->command));
}

TEST(CloseDialog, EnterKeepsGoingAndOnlyTheButtonStops) {
    ClosePanel p;
    p.driver.frame();
    p.driver.key(ImGuiKey_Enter);
    EXPECT_TRUE(p.closes());
    EXPECT_EQ(p.first<request::CloseSession>(), nullptr);
    ASSERT_TRUE(p.driver.click("close.stop"));
    ASSERT_NE(p.first<request::CloseSession>(), nullptr);
    EXPECT_TRUE(p.first<request::CloseSession>()->stop_first);
    EXPECT_NE(p.last<request::Quit>(), nullptr);
}

template <typename P>
class EveryDialog : public testing::Test {};
using Dialogs = testing::Types<ExportPanel, NewPanel, OpenPanel, NotePanel, SettingsPanel,
                               KeysPanel, ErrorPanel, ClosePanel>;
TYPED_TEST_SUITE(EveryDialog, Dialogs);

TYPED_TEST(EveryDialog, ClosesOnEscape) {
    TypeParam p;
    p.driver.frame();
    p.driver.frame();
    p.driver.key(ImGuiKey_Escape);
    EXPECT_TRUE(p.closes());
}

}  // namespace
}  // namespace gripscan::ui
