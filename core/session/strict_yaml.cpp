#include "core/session/strict_yaml.h"

#include "core/base/number_text.h"

namespace gripscan {

StrictYaml::StrictYaml(YAML::Node node, std::string name, std::shared_ptr<Shared> shared)
    : node_(std::move(node)), name_(std::move(name)), shared_(std::move(shared)) {
    std::set<std::string> seen;
    for (const auto& entry : node_) {
        if (!entry.first.IsScalar()) {
            fail_at(entry.first.Mark(), "a key must be a word");
        } else if (!seen.insert(entry.first.Scalar()).second) {
            fail_at(entry.first.Mark(),
                    fmt::format("{} is given twice", full_name(entry.first.Scalar())));
        }
    }
}

StrictYaml StrictYaml::parse(const std::filesystem::path& path, const std::string& text) {
    auto shared = std::make_shared<Shared>();
    shared->file = path.string();
    YAML::Node root;
    try {
        root = YAML::Load(text);
    } catch (const YAML::Exception& e) {
        shared->error =
            input_error("{}:{}: not valid YAML: {}", shared->file, e.mark.line + 1, e.msg).value();
    }
    if (!shared->error && !root.IsMap()) {
        shared->error = input_error("{}:1: expected 'key: value' lines", shared->file).value();
    }
    if (shared->error) root = YAML::Node(YAML::NodeType::Map);
    return StrictYaml(root, "", shared);
}

std::string StrictYaml::full_name(std::string_view key) const {
    return name_ + std::string(key);
}

void StrictYaml::fail_at(const YAML::Mark& mark, const std::string& what) {
    if (shared_->error) return;
    shared_->error = input_error("{}:{}: {}", shared_->file, mark.line + 1, what).value();
}

void StrictYaml::fail(std::string_view key, const std::string& what) {
    const auto node = find(key);
    fail_at(node ? node->Mark() : node_.Mark(), fmt::format("{} {}", full_name(key), what));
}

std::optional<YAML::Node> StrictYaml::find(std::string_view key) {
    known_.insert(std::string(key));
    for (const auto& entry : node_) {
        if (entry.first.IsScalar() && entry.first.Scalar() == key) return entry.second;
    }
    return std::nullopt;
}

std::optional<double> StrictYaml::number_of(const YAML::Node& node, std::string_view key) {
    // "?" is the tag of a plain scalar: a quoted number is a text.
    const auto value =
        node.IsScalar() && node.Tag() == "?" ? number_from_text(node.Scalar()) : std::nullopt;
    if (!value) {
        fail_at(node.Mark(), fmt::format("{} must be a finite number{}", full_name(key),
                                         node.IsScalar() ? ", not '" + node.Scalar() + "'" : ""));
    }
    return value;
}

std::optional<double> StrictYaml::number(std::string_view key) {
    const auto node = find(key);
    return node ? number_of(*node, key) : std::nullopt;
}

std::optional<std::string> StrictYaml::text(std::string_view key) {
    const auto node = find(key);
    if (!node) return std::nullopt;
    if (!node->IsScalar() || node->Scalar().empty()) {
        fail_at(node->Mark(), full_name(key) + " must be a text");
        return std::nullopt;
    }
    return node->Scalar();
}

std::optional<std::vector<double>> StrictYaml::numbers(std::string_view key, std::size_t count) {
    const auto node = find(key);
    if (!node) return std::nullopt;
    if (!node->IsSequence() || node->size() != count) {
        fail_at(node->Mark(),
                fmt::format("{} must be a list of {} numbers", full_name(key), count));
        return std::nullopt;
    }
    std::vector<double> values;
    for (const auto& item : *node) {
        const auto value = number_of(item, key);
        if (!value) return std::nullopt;
        values.push_back(*value);
    }
    return values;
}

std::optional<Eigen::Vector3d> StrictYaml::vector3(std::string_view key) {
    const auto values = numbers(key, 3);
    if (!values) return std::nullopt;
    return Eigen::Vector3d((*values)[0], (*values)[1], (*values)[2]);
}

std::optional<StrictYaml> StrictYaml::map(std::string_view key) {
    const auto node = find(key);
    if (!node) return std::nullopt;
    if (!node->IsMap()) {
        fail_at(node->Mark(), full_name(key) + " must hold 'key: value' pairs");
        return std::nullopt;
    }
    return StrictYaml(*node, full_name(key) + ".", shared_);
}

bool StrictYaml::holds_text(std::string_view key) {
    const auto node = find(key);
    return node && node->IsScalar();
}

std::optional<std::vector<StrictYaml>> StrictYaml::maps(std::string_view key) {
    const auto node = find(key);
    if (!node) return std::nullopt;
    const auto complain = [&](const YAML::Mark& mark) {
        fail_at(mark, full_name(key) + " must be a list of 'key: value' pairs");
    };
    if (!node->IsSequence()) {
        complain(node->Mark());
        return std::nullopt;
    }
    std::vector<StrictYaml> list;
    for (const auto& item : *node) {
        if (!item.IsMap()) {
            complain(item.Mark());
            return std::nullopt;
        }
        list.push_back(
            StrictYaml(item, fmt::format("{}[{}].", full_name(key), list.size()), shared_));
    }
    return list;
}

void StrictYaml::reject_other_keys() {
    for (const auto& entry : node_) {
        if (entry.first.IsScalar() && !known_.contains(entry.first.Scalar())) {
            fail_at(entry.first.Mark(),
                    fmt::format("unknown key '{}'", full_name(entry.first.Scalar())));
        }
    }
}

Status StrictYaml::status() const {
    if (shared_->error) return forward_error(*shared_->error);
    return {};
}

}  // namespace gripscan
