#include "core/report/library_json.h"

#include "core/report/json_parts.h"

namespace gripscan {
namespace {

Json entry_json(const Library& library, const LibraryEntry& entry) {
    Json json = Json::parse(sidecar_text(entry));
    json["path"] =
        std::filesystem::absolute(library.folder / entry.file).lexically_normal().string();
    json["lineage"] = word(lineage_of(library, entry));
    return json;
}

}  // namespace

std::string library_json(const Library& library) {
    Json list = Json::array();
    for (const LibraryEntry& entry : library.entries) list.push_back(entry_json(library, entry));
    return document_text({{"format", "gripscan-library-list/1"}, {"templates", list}});
}

std::string library_entry_json(const Library& library, const LibraryEntry& entry) {
    return document_text(entry_json(library, entry));
}

}  // namespace gripscan
