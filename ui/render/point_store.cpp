#include "ui/render/point_store.h"

#include <algorithm>
#include <cstddef>

namespace gripscan::ui {
namespace {

const void* at(std::size_t offset) {
    return reinterpret_cast<const void*>(offset);
}

void point_value_at(PointValue value) {
    constexpr GLsizei kStride = sizeof(PackedPoint);
    glEnableVertexAttribArray(2);
    switch (value) {
        case PointValue::kSeen:
            glVertexAttribPointer(2, 1, GL_UNSIGNED_SHORT, GL_FALSE, kStride,
                                  at(offsetof(PackedPoint, seen)));
            break;
        case PointValue::kStep:
            glVertexAttribPointer(2, 1, GL_UNSIGNED_SHORT, GL_FALSE, kStride,
                                  at(offsetof(PackedPoint, step)));
            break;
        case PointValue::kResidual:
            glVertexAttribPointer(2, 1, GL_FLOAT, GL_FALSE, kStride,
                                  at(offsetof(PackedPoint, residual_m)));
            break;
        case PointValue::kSigma:
            glVertexAttribPointer(2, 1, GL_FLOAT, GL_FALSE, kStride,
                                  at(offsetof(PackedPoint, sigma_m)));
            break;
        case PointValue::kNone:
            glDisableVertexAttribArray(2);
            break;
    }
}

}  // namespace

void PointStore::upload(Stored& stored, const PointChunk& chunk) {
    const std::vector<PackedPoint> points = packed_points(chunk);
    stored.generation = chunk.generation;
    stored.count = points.size();
    stored.value = PointValue::kNone;
    stored.bounds = chunk.cloud ? bounds_of(chunk.cloud->points) : Box{};
    glBindVertexArray(stored.attributes.name());
    glBindBuffer(GL_ARRAY_BUFFER, stored.points.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(points.size() * sizeof(PackedPoint)),
                 points.data(), GL_STATIC_DRAW);
    constexpr GLsizei kStride = sizeof(PackedPoint);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride, at(offsetof(PackedPoint, x_m)));
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 3, GL_BYTE, GL_TRUE, kStride, at(offsetof(PackedPoint, nx)));
    glEnableVertexAttribArray(3);
    glVertexAttribPointer(3, 1, GL_UNSIGNED_BYTE, GL_TRUE, kStride,
                          at(offsetof(PackedPoint, intensity)));
    glBindVertexArray(0);
}

std::size_t PointStore::sync(std::span<const PointChunk> chunks) {
    std::erase_if(stored_, [&](const auto& entry) {
        return std::none_of(chunks.begin(), chunks.end(),
                            [&](const PointChunk& c) { return c.id == entry.first; });
    });
    std::size_t uploaded = 0;
    for (const PointChunk& chunk : chunks) {
        const auto [entry, is_new] = stored_.try_emplace(chunk.id);
        if (!is_new && entry->second.generation == chunk.generation) continue;
        upload(entry->second, chunk);
        uploaded += entry->second.count;
    }
    return uploaded;
}

std::size_t PointStore::size(std::uint64_t id) const {
    const auto found = stored_.find(id);
    return found == stored_.end() ? 0 : found->second.count;
}

Box PointStore::bounds(std::uint64_t id) const {
    const auto found = stored_.find(id);
    return found == stored_.end() ? Box{} : found->second.bounds;
}

void PointStore::draw(std::uint64_t id, PointValue value, std::size_t first,
                      std::size_t end) const {
    const auto found = stored_.find(id);
    if (found == stored_.end() || end <= first) return;
    const Stored& stored = found->second;
    glBindVertexArray(stored.attributes.name());
    if (stored.value != value) {
        glBindBuffer(GL_ARRAY_BUFFER, stored.points.name());
        point_value_at(value);
        stored.value = value;
    }
    glDrawArrays(GL_POINTS, static_cast<GLint>(first), static_cast<GLsizei>(end - first));
}

}  // namespace gripscan::ui
