// Reading YAML strictly: every key has to be known and of the right type, and what is wrong is said
// with file and line. The first error sticks; readers go on and ask for `status()` once at the end.
// Includes yaml-cpp: for the sources of this folder only.
#pragma once

#include <yaml-cpp/yaml.h>

#include <Eigen/Core>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace gripscan {

/// One mapping of the file. Copies share the error and the file's name.
class StrictYaml {
  public:
    /// The document, which must be a mapping.
    [[nodiscard]] static StrictYaml parse(const std::filesystem::path& path,
                                          const std::string& text);

    /// Nothing where the key is absent, or wrong (then the error is kept).
    [[nodiscard]] std::optional<double> number(std::string_view key);
    [[nodiscard]] std::optional<std::string> text(std::string_view key);
    [[nodiscard]] std::optional<std::vector<double>> numbers(std::string_view key,
                                                             std::size_t count);
    [[nodiscard]] std::optional<Eigen::Vector3d> vector3(std::string_view key);
    [[nodiscard]] std::optional<StrictYaml> map(std::string_view key);
    /// A list of mappings.
    [[nodiscard]] std::optional<std::vector<StrictYaml>> maps(std::string_view key);
    /// A single word or number rather than a list or mapping.
    [[nodiscard]] bool holds_text(std::string_view key);
    /// Is the key there, whatever it holds? It counts as asked for.
    [[nodiscard]] bool has(std::string_view key) { return find(key).has_value(); }

    /// Records an error at the line of the key (of the mapping itself if the key is absent).
    void fail(std::string_view key, const std::string& what);
    /// Keys that nobody has asked for are errors.
    void reject_other_keys();
    [[nodiscard]] Status status() const;

  private:
    struct Shared {
        std::string file;
        std::optional<Error> error;
    };
    StrictYaml(YAML::Node node, std::string name, std::shared_ptr<Shared> shared);
    [[nodiscard]] std::optional<YAML::Node> find(std::string_view key);
    [[nodiscard]] std::string full_name(std::string_view key) const;
    [[nodiscard]] std::optional<double> number_of(const YAML::Node& node, std::string_view key);
    void fail_at(const YAML::Mark& mark, const std::string& what);

    YAML::Node node_;
    std::string name_;  ///< "limits." for a nested mapping
    std::set<std::string, std::less<>> known_;
    std::shared_ptr<Shared> shared_;
};

}  // namespace gripscan
