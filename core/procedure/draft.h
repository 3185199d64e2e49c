// A transition in the making, and the moves that several inputs share. For the sources of step()
// only.
#pragma once

#include <string>
#include <vector>

#include "core/procedure/step.h"

namespace gripscan {

class Draft {
  public:
    explicit Draft(const ProcedureState& from) : state(from) {}

    ProcedureState state;
    std::vector<Effect> effects;
    std::optional<std::string> refused;

    void refuse(std::string why) { refused = std::move(why); }

    /// Starts an activity and asks for its effect.
    void begin(Activity activity);
    /// Joint 6 to an absolute angle, then the shot; in DRY it is only written down, without motion
    /// rights the operator is waited for.
    void drive_to(double joint6_rad, const std::optional<Shot>& shot);
    /// Takes the shot where it belongs: drives there first if joint 6 stands elsewhere.
    void shoot(const Shot& shot);
    /// The same, and where the joint stands there already it is approached anew: which way it came
    /// is not known.
    void shoot_from_below(const Shot& shot);
    /// Begins what an interrupted activity still needs, as things are now.
    void begin_again(const Activity& activity);

    /// Remembers the data before they change; what could be redone is gone.
    void remember();
    /// After any change of the data: they are saved, results no longer hold, pairs of neighbours
    /// that are not judged yet are judged, and then it is decided how to go on.
    void data_changed();
    /// The next pair that is not judged, or rest().
    void judge_next();
    /// Nothing is going on: finished, a step to be decided upon, or idle.
    void rest();
    /// The steps into and out of a capture are to be judged again.
    void forget_judged(int index);

    /// Settles at which joint angle the turn begins, if that is open.
    void settle_start();
    [[nodiscard]] double joint6_of(double commanded_rad) const;
    /// A shot at an angle of the turn, counted as an attempt there.
    [[nodiscard]] Shot shot_at(double commanded_rad) const;
    [[nodiscard]] Shot warm_up_shot() const;
    /// Joint 6 at its first picture. One that was cut off is begun again at the same angles, if the
    /// joint still stands among them.
    [[nodiscard]] double start_of_warm_up() const;
    /// In pieces the controller allows, arriving upwards.
    [[nodiscard]] std::vector<double> way_from(double from_rad, double to_rad) const;

  private:
    /// Where a resumed run stands is not trusted. Journals that do not say where the warm-up is
    /// made were written by a program that did not do so, and are read by its rules.
    [[nodiscard]] bool approaches_anew() const;
    /// The joint stands where it can be on its way to the end of this motion.
    [[nodiscard]] bool may_be_under_way(const activity::Moving& moving) const;
    void log_way_to(double joint6_rad);
    void send(std::vector<double> way, const std::optional<Shot>& shot);
};

/// The command's own part of step(); Draft::refused where it makes no sense now.
void take_command(Draft& draft, const Command& command);
void take_event(Draft& draft, const Event& event);

/// What to do about the last row of Table 1, which is not accepted.
[[nodiscard]] Advice advice_for(const ProcedureState& state);

/// Same angle of the turn: commanded angles are computed, not measured.
[[nodiscard]] bool same_angle(double a_rad, double b_rad);

}  // namespace gripscan
