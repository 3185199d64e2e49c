// A table of words and rounded numbers, as the views make them, drawn by the table widget.
#pragma once

#include "ui/views/table_text.h"
#include "ui/widgets/data_table.h"

namespace gripscan::ui {

TableEvent draw_text_table(const Ui& ui, const Rect& rect, std::string_view id,
                           const TableText& text, std::optional<std::size_t> selected, bool follow);

}  // namespace gripscan::ui
