// A screen in memory (Xvfb) for as long as the object lives; DISPLAY names it.
#pragma once

#include <sys/types.h>

#include <memory>

namespace gripscan::test {

class VirtualScreen {
  public:
    /// Nothing where Xvfb does not start.
    [[nodiscard]] static std::unique_ptr<VirtualScreen> make();
    ~VirtualScreen();
    VirtualScreen(const VirtualScreen&) = delete;
    VirtualScreen& operator=(const VirtualScreen&) = delete;

  private:
    explicit VirtualScreen(pid_t server) : server_(server) {}
    pid_t server_;
};

}  // namespace gripscan::test
