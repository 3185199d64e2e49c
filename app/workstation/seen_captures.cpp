#include "app/workstation/seen_captures.h"

#include "app/workstation/picture_facts.h"

namespace gripscan::app {
namespace {

std::shared_ptr<const ui::StereoPicture> picture_of(const RecordedCapture& capture,
                                                    const PreparedCapture& prepared,
                                                    const Rectifier* rectifier) {
    if (rectifier == nullptr || !capture.load_images) return nullptr;
    const auto frame = capture.load_images();
    if (!frame) return nullptr;
    auto rectified = rectifier->rectify(*frame);
    if (!rectified) return nullptr;
    auto picture = std::make_shared<ui::StereoPicture>();
    picture->left = rectified->left.clone();
    picture->right = rectified->right.clone();
    picture->disparity = disparity_of(prepared.view.cloud, rectifier->rig());
    picture->left_health = prepared.health;
    picture->t_s = frame->t_s;
    return picture;
}

void drop_disparity(ui::ShownCapture& capture) {
    if (!capture.picture || capture.picture->disparity.empty()) return;
    auto without = std::make_shared<ui::StereoPicture>(*capture.picture);
    without->disparity.release();
    capture.picture = std::move(without);
}

}  // namespace

Status SeenCaptures::set_rig(const StereoRig& rig) {
    auto rectifier = Rectifier::create(rig);
    if (!rectifier) return forward_error(rectifier.error());
    const std::lock_guard lock(mutex_);
    rectifier_ = std::make_shared<Rectifier>(std::move(*rectifier));
    return {};
}

std::optional<RectifiedRig> SeenCaptures::rig() const {
    const std::lock_guard lock(mutex_);
    if (!rectifier_) return std::nullopt;
    return rectifier_->rig();
}

void SeenCaptures::add(const RecordedCapture& capture, const PreparedCapture& prepared) {
    std::shared_ptr<const Rectifier> rectifier;
    {
        const std::lock_guard lock(mutex_);
        rectifier = rectifier_;
    }
    ui::ShownCapture shown;
    shown.index = capture.index;
    shown.attempt = capture.attempts;
    shown.cloud = std::make_shared<Cloud>(prepared.view.cloud);
    shown.split = prepared.split;
    shown.picture = picture_of(capture, prepared, rectifier.get());
    {
        const std::lock_guard lock(mutex_);
        // One disparity image is as large as five images: only the latest capture keeps its own.
        for (auto& [index, other] : captures_) drop_disparity(other);
        shown.generation = ++generation_;
        captures_[shown.index] = std::move(shown);
    }
    wake_();
}

std::vector<ui::ShownCapture> SeenCaptures::all() const {
    const std::lock_guard lock(mutex_);
    std::vector<ui::ShownCapture> all;
    for (const auto& [index, capture] : captures_) all.push_back(capture);
    return all;
}

std::uint64_t SeenCaptures::generation() const {
    const std::lock_guard lock(mutex_);
    return generation_;
}

}  // namespace gripscan::app
