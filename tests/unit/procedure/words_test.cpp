#include <gmock/gmock.h>

#include <set>

#include "core/procedure/advice.h"
#include "core/procedure/field_words.h"
#include "core/procedure/input_words.h"

namespace gripscan {

/// No journal holds it; scripts read it from what is said.
template <>
inline constexpr auto kLastOf<AdvisedAction> = AdvisedAction::kStop;

namespace {

using testing::ElementsAre;

/// Lower case, digits and underscores: safe in files, greps and command lines.
bool is_plain(std::string_view word) {
    return !word.empty() && word.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") ==
                                std::string_view::npos;
}

template <typename Variant>
void expect_unique_words() {
    const auto& words = input_words<Variant>();
    EXPECT_EQ(std::set(words.begin(), words.end()).size(), std::variant_size_v<Variant>);
    for (const auto word : words) EXPECT_TRUE(is_plain(word)) << word;
}

TEST(Words, EveryCommandAndEventHasItsOwn) {
    expect_unique_words<Command>();
    expect_unique_words<Event>();
}

/// The order of the words is that of the variant: one that was moved would read journals wrongly.
TEST(Words, BelongToTheirCommands) {
    using namespace command;
    std::vector<std::string_view> words;
    for (const Command& c : std::initializer_list<Command>{
             Connect{},   CheckCell{},    WarmUp{}, Capture{}, Step{},   Retry{},   Halve{},
             LockAxis{},  Accept{},       Back{},   Undo{},    Redo{},   Exclude{}, Retake{},
             TellAngle{}, command::Run{}, Pause{},  Stop{},    Resume{}, Finish{},  SetPlan{}}) {
        words.push_back(word(c));
    }
    EXPECT_THAT(words,
                ElementsAre("connect", "check_cell", "warm_up", "capture", "step", "retry", "halve",
                            "lock_axis", "accept", "back", "undo", "redo", "exclude", "retake",
                            "tell_angle", "run", "pause", "stop", "resume", "finish", "set_plan"));
}

TEST(Words, BelongToTheirEvents) {
    using namespace event;
    std::vector<std::string_view> words;
    for (const Event& e : std::initializer_list<Event>{
             LinkUp{}, LinkDown{}, CellChecked{}, Arrived{}, TurnFailed{}, TurnLogged{}, Exposed{},
             ExposureFailed{}, Judged{}, AxisFound{}, Solved{}, WorkFailed{}, ProgramEnded{}}) {
        words.push_back(word(e));
    }
    EXPECT_THAT(words, ElementsAre("link_up", "link_down", "cell_checked", "arrived", "turn_failed",
                                   "turn_logged", "exposed", "exposure_failed", "judged",
                                   "axis_found", "solved", "work_failed", "program_ended"));
}

template <typename Enum>
class EnumerationWords : public testing::Test {};
using Enumerations = testing::Types<Verdict, Cause, TurnMode, CaptureStatus, CheckOutcome,
                                    RobotFault, MotionMode, AdvisedAction>;
TYPED_TEST_SUITE(EnumerationWords, Enumerations);

/// A word that two values share would lead back to the first of them only.
TYPED_TEST(EnumerationWords, LeadBackToTheirValues) {
    for (int i = 0; i <= static_cast<int>(kLastOf<TypeParam>); ++i) {
        const auto value = static_cast<TypeParam>(i);
        EXPECT_FALSE(word(value).empty());
        EXPECT_EQ(value_of_word<TypeParam>(word(value)), value) << word(value);
    }
    EXPECT_FALSE(value_of_word<TypeParam>(""));
    EXPECT_FALSE(value_of_word<TypeParam>("unheard of"));
}

}  // namespace
}  // namespace gripscan
