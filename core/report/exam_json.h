// `exam --json`.
#pragma once

#include <string>

#include "core/recognition/exam.h"

namespace gripscan {

[[nodiscard]] std::string exam_json(const ExamResult& exam);

}  // namespace gripscan
