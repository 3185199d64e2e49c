#include <atomic>

#include "core/camera/image_file.h"
#include "core/cloud/cloud_file.h"
#include "core/session/session.h"

namespace gripscan {
namespace {

Status check_image(const Session& session, const CaptureRow& row, const std::string& relative) {
    const auto path = session.file(relative);
    const auto image = load_grey_image(path);
    if (!image) {
        return input_error("capture {}: {}", row.index, image.error().message);
    }
    if (session.rig && ImageSize{image->cols, image->rows} != session.rig->image) {
        return input_error("capture {}: {} is {} x {} px, but rig.yaml is for {} x {} px",
                           row.index, path.string(), image->cols, image->rows,
                           session.rig->image.width, session.rig->image.height);
    }
    return {};
}

Status check_row(const Session& session, const CaptureRow& row) {
    if (Session::uses_images(row)) {
        if (Status status = check_image(session, row, row.left); !status) return status;
        if (Status status = check_image(session, row, row.right); !status) return status;
    }
    if (!row.cloud.empty()) {
        const auto cloud = load_cloud(session.file(row.cloud));
        if (!cloud) return input_error("capture {}: {}", row.index, cloud.error().message);
    }
    return {};
}

}  // namespace

Status check_session_files(const Session& session, const Progress& progress,
                           const ForEach& for_each) {
    const auto& rows = session.table.rows;
    std::vector<Status> checked(rows.size());
    std::atomic<std::size_t> done{0};
    progress.tell("check files", 0, rows.size());
    for_each(rows.size(), [&](std::size_t i) {
        checked[i] = progress.cancelled() ? Status(cancelled_error()) : check_row(session, rows[i]);
        progress.tell("check files", ++done, rows.size());
    });
    for (const auto& status : checked) {
        if (!status) return status;
    }
    return {};
}

}  // namespace gripscan
