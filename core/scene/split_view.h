// A capture of an object's turn made ready: taken apart, the object's part to be registered, the
// gripper's part beside it as what holds it.
#pragma once

#include <memory>

#include "core/registration/turn_view.h"
#include "core/scene/object_split.h"

namespace gripscan {

struct SplitView {
    PreparedView view;  ///< of the object; a gripper that was not found is its flaw
    std::shared_ptr<const ObjectSplit> split;  ///< null: the view is too poor to be taken apart
};

[[nodiscard]] SplitView prepare_split_view(const GripperTemplate& gripper,
                                           const ObjectSplitSettings& settings,
                                           const CaptureFacts& facts, Cloud scene);

}  // namespace gripscan
