// The controller's sources cannot be compiled here. What can be checked by text is: the limits of
// KAREL, that nothing is left open, and that they speak the protocol of gsp_message.h.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "core/robot/gsp_message.h"

namespace gripscan::gsp {
namespace {
namespace fs = std::filesystem;

using testing::Contains;
using testing::HasSubstr;

std::string text_of(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

const fs::path& folder() {
    static const fs::path path = fs::path(GRIPSCAN_SOURCE_DIR) / "assets" / "fanuc";
    return path;
}

std::map<std::string, std::string> karel_sources() {
    std::map<std::string, std::string> sources;
    for (const auto& entry : fs::directory_iterator(folder())) {
        if (entry.path().extension() != ".kl") continue;
        sources[entry.path().stem().string()] = text_of(entry.path());
    }
    return sources;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// Without comments and without what stands between quotes.
std::string code_of(const std::string& text) {
    static const std::regex quoted("'[^'\n]*'");
    static const std::regex comment("--[^\n]*");
    return std::regex_replace(std::regex_replace(text, quoted, "''"), comment, "");
}

std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
    const std::regex regex(pattern);
    std::vector<std::string> found;
    for (auto it = std::sregex_iterator(text.begin(), text.end(), regex);
         it != std::sregex_iterator(); ++it) {
        found.push_back((*it)[1]);
    }
    return found;
}

std::size_t count(const std::string& text, const std::string& word) {
    return matches(text, "\\b(" + word + ")\\b").size();
}

std::string all_sources() {
    std::string all;
    for (const auto& [name, text] : karel_sources()) all += text;
    return all;
}

/// The value of a constant of gs_conf.kl.
std::string constant(const std::string& name) {
    const auto found =
        matches(karel_sources().at("gs_conf"), "\\b" + name + "\\s*=\\s*('?[^ \n]*)");
    return found.empty() ? "" : found.front();
}

TEST(FanucSources, KeepToTheLimitsOfKarel) {
    ASSERT_EQ(karel_sources().size(), 6U);
    for (const auto& [name, text] : karel_sources()) {
        EXPECT_LE(name.size(), 12U) << name;
        int number = 0;
        for (const std::string& line : lines_of(text)) {
            ++number;
            EXPECT_LE(line.size(), 80U) << name << ":" << number;
            for (const char c : line) {
                EXPECT_TRUE(c >= ' ' && c <= '~') << name << ":" << number << ": not plain ASCII";
            }
        }
        for (const std::string& size : matches(text, "STRING\\[(\\d+)\\]")) {
            EXPECT_LE(std::stoi(size), 254) << name;
        }
    }
}

TEST(FanucSources, NamesAreShortAndNotReserved) {
    static const std::set<std::string> kReserved{
        "abort",  "after",  "along", "and",    "array",  "at",     "away",   "axis",
        "before", "begin",  "by",    "cancel", "close",  "cr",     "delay",  "div",
        "do",     "else",   "end",   "error",  "event",  "file",   "for",    "from",
        "go",     "group",  "hand",  "hold",   "if",     "in",     "mod",    "model",
        "move",   "near",   "node",  "not",    "of",     "open",   "or",     "path",
        "pause",  "pulse",  "read",  "relax",  "repeat", "resume", "select", "signal",
        "stop",   "string", "then",  "time",   "timer",  "to",     "type",   "until",
        "using",  "vector", "via",   "wait",   "when",   "while",  "with",   "write"};
    for (const auto& [file, text] : karel_sources()) {
        const std::string code = code_of(text);
        auto names = matches(code, "ROUTINE\\s+(\\w+)");
        for (const char* declared : {"\n\\s+(\\w+)\\s*(?:IN CMOS\\s*)?:\\s*(?:INTEGER|REAL|BOOLEAN|"
                                     "STRING|FILE|JOINTPOS|ARRAY|XYZWPR|CONFIG)",
                                     "\n\\s+(\\w+)\\s*=\\s*[-'\\d]"}) {
            for (const auto& name : matches(code, declared)) names.push_back(name);
        }
        EXPECT_GT(names.size(), 4U) << file;
        for (const std::string& name : names) {
            EXPECT_LE(name.size(), 12U) << file << ": " << name;
            EXPECT_FALSE(kReserved.contains(name)) << file << ": " << name << " is reserved";
        }
    }
}

TEST(FanucSources, NothingIsLeftOpen) {
    for (const auto& [name, text] : karel_sources()) {
        const std::string code = code_of(text);
        EXPECT_EQ(count(code, "IF"), count(code, "ENDIF")) << name;
        EXPECT_EQ(count(code, "IF"), count(code, "THEN")) << name;
        EXPECT_EQ(count(code, "WHILE"), count(code, "ENDWHILE")) << name;
        EXPECT_EQ(count(code, "FOR"), count(code, "ENDFOR")) << name;
        EXPECT_EQ(count(code, "SELECT"), count(code, "ENDSELECT")) << name;
        for (const std::string& routine : matches(code, "(?:ROUTINE|PROGRAM)\\s+(\\w+)")) {
            EXPECT_EQ(matches(code, "\nEND (" + routine + ")\\b").size(), 1U) << routine;
        }
        EXPECT_EQ(std::count(code.begin(), code.end(), '('),
                  std::count(code.begin(), code.end(), ')'))
            << name;
    }
}

TEST(FanucSources, EveryIncludeIsThereAndEveryRoutineIsUsed) {
    const auto sources = karel_sources();
    const std::string all = code_of(all_sources());
    for (const char* program : {"gs_motion", "gs_monitor"}) {
        const std::string& text = sources.at(program);
        EXPECT_THAT(text, HasSubstr("%NOLOCKGROUP"));
        EXPECT_THAT(text, HasSubstr("%NOPAUSE = ERROR + COMMAND + TPENABLE"));
        for (const std::string& include : matches(text, "%INCLUDE (\\w+)")) {
            EXPECT_TRUE(include == "kliosop" || sources.contains(include)) << include;
        }
    }
    for (const std::string& routine : matches(all, "ROUTINE\\s+(\\w+)")) {
        EXPECT_GT(count(all, routine), 2U) << routine << " is declared and ended, never called";
    }
}

TEST(FanucSources, ConnectInTheOrderThatControllersNeed) {
    const std::string link = code_of(karel_sources().at("gs_link"));
    std::size_t last = 0;
    for (const char* call :
         {"SET_VAR(", "MSG_DISCO(", "SET_FILE_ATR(", "MSG_CONNECT(", "OPEN FILE"}) {
        const auto found = link.find(call);
        ASSERT_NE(found, std::string::npos) << call;
        EXPECT_GT(found, last) << call;
        last = found;
    }
    EXPECT_THAT(link, HasSubstr("ATR_IA"));
    EXPECT_THAT(link, HasSubstr("UNINIT(line)"));
}

TEST(FanucSources, CanSayEveryErrorOfTheProtocolAndNoOther) {
    const std::string all = all_sources();
    std::set<std::string> known;
    for (const ErrorRow& row : error_table()) {
        const std::string code = std::to_string(static_cast<int>(row.code));
        known.insert(code);
        EXPECT_GT(count(code_of(all), code), 0U) << code << " " << row.words;
    }
    for (const auto& code : matches(code_of(all), "err_line\\(\\w+, (\\d+),")) {
        EXPECT_THAT(known, Contains(code));
    }
    for (const auto& code : matches(code_of(all), "RETURN \\((\\d\\d\\d)\\)")) {
        EXPECT_THAT(known, Contains(code));
    }
}

TEST(FanucSources, SpeakTheWordsOfTheProtocol) {
    const std::string all = all_sources();
    for (const std::string& request :
         {encode(Request(AskState{})), encode(Request(AskPosition{})), encode(Request(Stop{}))}) {
        EXPECT_THAT(all, HasSubstr("'" + request + "'"));
    }
    EXPECT_THAT(all, HasSubstr("word = 'HELLO'"));
    EXPECT_THAT(all, HasSubstr("word = 'J6ABS'"));
    for (const char* reply :
         {"'OK HELLO '", "'OK STATE '", "'OK STOP'", "'OK ACC '", "'DONE '", "'ERR '", "'POS '"}) {
        EXPECT_THAT(all, HasSubstr(reply));
    }
    EXPECT_THAT(all, HasSubstr("'last=' + int_text(last_id)"));
    EXPECT_EQ(constant("GS_PROTO"), "'" + std::string(kVersionText) + "'");
    EXPECT_EQ(constant("GS_AXES"), std::to_string(kAxes));
    EXPECT_EQ(constant("MOT_PORT"), std::to_string(kMotionPort));
    EXPECT_EQ(constant("MON_PORT"), std::to_string(kMotionPort + 1));
}

TEST(FanucSources, TheTpProgramIsWellFormedAndUsesTheSameRegisters) {
    const std::string text = text_of(folder() / "gripscan.ls");
    int number = 0;
    for (const std::string& line : lines_of(text)) {
        std::smatch match;
        if (!std::regex_match(line, match, std::regex("\\s*(\\d+):.*;"))) continue;
        EXPECT_EQ(std::stoi(match[1]), ++number) << line;
    }
    EXPECT_THAT(text, HasSubstr("LINE_COUNT\t= " + std::to_string(number) + ";"));
    EXPECT_THAT(text, HasSubstr("J PR[" + constant("PR_TARGET") + ":GS target] R[" +
                                constant("R_SPEED") + ":GS speed]% FINE Skip,LBL[20]"));
    EXPECT_THAT(text, HasSubstr("SKIP CONDITION R[" + constant("R_STOP") + ":GS stop]=1"));
    EXPECT_THAT(text, HasSubstr("R[" + constant("R_RESULT") + ":GS result]=2"));
    EXPECT_THAT(text, HasSubstr("F[" + constant("F_READY") + ":GS ready]=(ON)"));
    EXPECT_THAT(text, HasSubstr("WAIT (F[" + constant("F_GO") + ":GS go])"));
    EXPECT_THAT(text, HasSubstr("UFRAME_NUM=" + constant("GS_UFRAME")));
    EXPECT_THAT(text, HasSubstr("UTOOL_NUM=" + constant("GS_UTOOL")));
    for (const char* task : {"RUN GS_MONITOR", "RUN GS_MOTION"}) EXPECT_THAT(text, HasSubstr(task));
}

TEST(FanucSources, TheSetUpPageNamesWhatIsUsed) {
    const std::string page = text_of(folder() / "README.md");
    for (const std::string& word :
         {std::string("R632"), std::string("R648"), std::string("Never compiled"),
          std::string("No safety function"), std::string("gripscan robot-check"),
          "port " + constant("MOT_PORT"), "port " + constant("MON_PORT"), "S" + constant("MOT_TAG"),
          "S" + constant("MON_TAG"), "PR[" + constant("PR_TARGET") + "]",
          "R[" + constant("R_SPEED") + "]", "R[" + constant("R_STOP") + "]",
          "R[" + constant("R_RESULT") + "]", "F[" + constant("F_READY") + "]",
          "F[" + constant("F_GO") + "]"}) {
        EXPECT_THAT(page, HasSubstr(word));
    }
}

}  // namespace
}  // namespace gripscan::gsp
