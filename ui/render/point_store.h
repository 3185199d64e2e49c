// The chunks that lie in the memory of the graphics card.
#pragma once

#include <map>
#include <span>

#include "ui/gl/gl_object.h"
#include "ui/render/point_chunk.h"

namespace gripscan::ui {

/// Which number of a point colours it.
enum class PointValue { kNone, kSeen, kStep, kResidual, kSigma };

class PointStore {
  public:
    /// Uploads chunks that are new or have another generation, and forgets those that are gone.
    /// Returns the number of points uploaded.
    std::size_t sync(std::span<const PointChunk> chunks);

    /// Points of a chunk that is there; 0 else.
    [[nodiscard]] std::size_t size(std::uint64_t id) const;
    /// Around the chunk's points, in its own frame; not valid where there are none.
    [[nodiscard]] Box bounds(std::uint64_t id) const;
    /// Draws points [first, end) with the program in use.
    void draw(std::uint64_t id, PointValue value, std::size_t first, std::size_t end) const;

  private:
    struct Stored {
        std::uint64_t generation = 0;
        std::size_t count = 0;
        Box bounds;
        GlBuffer points;
        GlVertexArray attributes;
        mutable PointValue value = PointValue::kNone;  ///< what the attributes point at
    };
    static void upload(Stored& stored, const PointChunk& chunk);
    std::map<std::uint64_t, Stored> stored_;
};

}  // namespace gripscan::ui
