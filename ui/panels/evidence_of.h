// The words of a line of evidence as its row shows them.
#pragma once

#include "ui/views/step_text.h"
#include "ui/widgets/evidence_row.h"

namespace gripscan::ui {

/// Refers to the words.
[[nodiscard]] inline Evidence evidence_of(const EvidenceText& e) {
    return {e.id,    e.label,          e.value,
            e.unit,  e.decimals,       e.with_sign,
            e.limit, e.limit_decimals, e.at_least ? LimitKind::kAtLeast : LimitKind::kAtMost,
            e.state, e.meaning};
}

}  // namespace gripscan::ui
