#include <gmock/gmock.h>

#include <filesystem>

#include "tests/console/console.h"
#include "tests/support/file_content.h"
#include "tests/support/hostile_session.h"

// Whatever names, notes and files contain, the output is the same text without effect on the terminal.

namespace alidade::test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using Json = nlohmann::ordered_json;

/// Expects only visible characters and line ends.
void expectVisible(const std::string& text, const std::string& of) {
  const auto at = firstForbidden(text);
  EXPECT_FALSE(at) << of << ": …" << ::testing::PrintToString(text.substr(*at < 20 ? 0 : *at - 20, 60));
}

void expectVisible(const ProgramRun& run, const std::string& of) {
  expectVisible(run.out, of + ", stdout");
  expectVisible(run.err, of + ", stderr");
}

std::string hostilePaperSession(const std::string& text) {
  return hostileSession(contentOf(paperSession), text);
}

ProgramRun publishedFit(const std::string& session,
                        std::vector<std::string> more = {"--method", "published"}) {
  more.insert(more.begin(), {"fit", "-"});
  return runProgram({.program = ALIDADE_CLI, .arguments = std::move(more), .input = session});
}

TEST(HostileTexts, AreAllForbiddenButTheMarkup) {
  for (const HostileText& hostile : hostileTexts)
    EXPECT_EQ(firstForbidden(hostile.text, "").has_value(), std::string_view(hostile.what) != "markup")
        << hostile.what;
  EXPECT_EQ(firstForbidden("341°52′24″\n"), std::nullopt);
  EXPECT_EQ(firstForbidden("ab\xC2"), 2u);
}

TEST(HostileTexts, AreTextInTheNameOfASession) {
  for (const HostileText& hostile : hostileTexts) {
    const ProgramRun run = publishedFit(hostilePaperSession(std::string(hostile.text)));
    EXPECT_EQ(run.exitCode, 0) << run.err;
    expectVisible(run, hostile.what);
    EXPECT_EQ(run.out.find('\n'), run.out.find("\n\nPublished method")) << "the name is one line";
  }
  const ProgramRun run = publishedFit(hostilePaperSession("<b>&amp; \x1b[31m\u202Ex"));
  EXPECT_THAT(run.out, StartsWith("<b>&amp; \\u001b[31m\\u202ex\n"));
  EXPECT_THAT(publishedFit(hostilePaperSession("50 % שלום 北京\u00A0é")).out,
              StartsWith("50 % שלום 北京\u00A0é\n"));
}

TEST(HostileTexts, AreTextInEveryAnswerAndExactInJson) {
  const TemporaryFolder folder;
  const std::string all = allHostileTexts();
  const std::string file = folder.file("all.alidade", hostilePaperSession(all));
  for (const char* command : {"fit", "diagnose", "plan"}) {
    const ProgramRun text = alidadeCli({command, file});
    EXPECT_EQ(text.exitCode, 0) << text.err;
    expectVisible(text, command);
    EXPECT_THAT(text.out, HasSubstr("a\\u001b[2J")) << command;
    const ProgramRun json = alidadeCli({command, file, "--json"});
    EXPECT_EQ(json.exitCode, 0) << json.err;
    expectVisible(json, command);
    EXPECT_EQ(Json::parse(json.out).at("session").get<std::string>(), all) << command;
  }
}

TEST(HostileTexts, AreTextInTheRefusalOfEveryEntry) {
  const auto refused = [](const char* what, auto change) {
    const ProgramRun run = publishedFit(changedPaperSession(change));
    expectRefusal(run);
    expectVisible(run, what);
  };
  const std::string all = allHostileTexts();
  refused("format", [&](Json& s) { s["format"] = all; });
  refused("circle", [&](Json& s) { s["geometry"]["vertical_circle"] = all; });
  refused("relation", [&](Json& s) { s["model"]["vertical_angle"] = all; });
  refused("radius", [&](Json& s) { s["model"]["radius"] = all; });
  refused("axis", [&](Json& s) { s["positions"][0]["axis_deg"] = all; });
  refused("zero", [&](Json& s) { s["positions"][0]["pointing_zero"]["vertical"] = all; });
  for (const char* key : {"distance_mm", "sigma_distance_mm", "radius_mm", "sigma_radius_mm"})
    refused(key, [&](Json& s) { s["geometry"][key] = all; });
  for (const char* key : {"tolerance_mm", "coverage", "reference_intersection_mm", "sigma_reference_mm"})
    refused(key, [&](Json& s) { s["acceptance"][key] = all; });
  for (const char* key : {"sigma_horizontal_arcsec", "sigma_zero_arcsec", "sigma_slider_arcsec"})
    refused(key, [&](Json& s) { s["instrument"][key] = all; });
  for (const char* key : {"point", "round", "face", "horizontal", "vertical", "slider"})
    refused(key, [&](Json& s) { s["positions"][1]["readings"][2][key] = all; });
}

/// A date does not affect any number: its problem is reported, and the result remains.
TEST(HostileTexts, AreTextInWhatIsToldOfADate) {
  const ProgramRun run =
      publishedFit(changedPaperSession([](Json& s) { s["measured_on"] = allHostileTexts(); }));
  EXPECT_EQ(run.exitCode, 0);
  expectVisible(run, "date");
  EXPECT_THAT(run.err, HasSubstr("measured_on: "));
}

TEST(HostileTexts, AreTextInTheRefusalOfAFile) {
  const std::string all = allHostileTexts();
  const std::string key = Json(all).dump();
  const std::vector<std::string> contents = {all,
                                             "{\"" + all + "\": 1}",
                                             "{\"a\": \"" + all + "\"}",
                                             "{\"format\" \x1b[31m\u202E}",
                                             Json({{all, 1}}).dump() + "\x1b[2J",
                                             "[" + key + ", tru\u202E]",
                                             "{" + key + ": 1, " + key + ": 2}",
                                             "{\"positions\": [{" + key + ": {\"x\": 1, \"x\": 2}}]}"};
  for (const std::string& content : contents) {
    const ProgramRun run = publishedFit(content);
    expectRefusal(run);
    expectVisible(run, content);
  }
}

TEST(HostileTexts, ThatAreNoUtf8AreRefusedByLineAndColumn) {
  for (const char* bytes : {"\xFF", "\xC0\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xC3"}) {
    std::string session = contentOf(paperSession);
    session.insert(session.find("Table I"), bytes);
    const ProgramRun run = publishedFit(session);
    expectRefusal(run);
    EXPECT_THAT(run.err, HasSubstr("is not UTF-8 text at line "));
  }
}

TEST(HostileTexts, AreTextInTheNameOfAFile) {
  const TemporaryFolder folder;
  const std::string untitled = changedPaperSession([](Json& session) { session.erase("title"); });
  std::vector<std::string> names = {"no\xFFtext\xC3.alidade"};
  for (const HostileText& hostile : hostileTexts) names.emplace_back(hostile.text);
  for (const std::string& name : names) {
    const std::string missing = (folder.path() / name).string();
    const ProgramRun absent = alidadeCli({"fit", missing});
    expectRefusal(absent);
    expectVisible(absent, name);
    const ProgramRun run = alidadeCli({"fit", folder.file(name, untitled), "--method", "published"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    expectVisible(run, name);
  }
  const std::string json = alidadeCli({"fit", (folder.path() / names[0]).string(), "--json"}).out;
  EXPECT_EQ(Json::parse(json).at("session"), "no\\xfftext\\xc3.alidade");
  EXPECT_EQ(firstForbidden(json), std::nullopt);
}

TEST(HostileTexts, AreTextInACall) {
  const TemporaryFolder folder;
  for (const std::string& text : {allHostileTexts(), std::string("a\xFF\x9b")}) {
    const std::string out = (folder.path() / "s.alidade").string(), truth = (folder.path() / "t").string();
    for (const std::vector<std::string>& call : std::vector<std::vector<std::string>>{
             {text},
             {"--" + text},
             {"fit", paperSession, "--" + text},
             {"fit", text},
             {"plan", paperSession, text},
             {"fit", paperSession, "--method", text},
             {"fit", paperSession, "--risk", text},
             {"diagnose", paperSession, "--without", text},
             {"simulate", "--out", out, "--truth", truth, "--effect", text},
             {"simulate", "--out", out, "--truth", truth, "--effect", text + "=1"},
             {"simulate", "--out", out, "--truth", truth, "--effect", "collimation=" + text},
             {"simulate", "--out", out, "--truth", truth, "--protocol", text},
             {"simulate", "--out", "/no/" + text, "--truth", truth},
             {"trial", "--score", text},
             {"trial", "--protocol", text},
             {"import", paperSession, "--out", out},
             {"import", paperSession, "--out", out, "--distance", text},
             {"import", paperSession, "--out", out, "--zero-0", text, "90"},
         }) {
      const ProgramRun run = alidadeCli(call);
      expectRefusal(run);
      expectVisible(run, ::testing::PrintToString(call));
    }
  }
}

TEST(HostileTexts, KeepWhatWasTypedInASimulatedSession) {
  const TemporaryFolder folder;
  const std::string all = allHostileTexts(), out = (folder.path() / "a\x1b[2J\u202E.alidade").string();
  const std::string truth = (folder.path() / "t\n.json").string();
  const ProgramRun run =
      alidadeCli({"simulate", "--out", out, "--truth", truth, "--title", all, "--notes", all});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  expectVisible(run, "simulate");
  const Json session = Json::parse(contentOf(out));
  EXPECT_EQ(session.at("title"), all);
  EXPECT_EQ(session.at("notes"), all);
  for (const char* option : {"--title", "--notes"}) {
    const ProgramRun refused = alidadeCli({"simulate", "--out", out, "--truth", truth, option, "a\xFF"});
    expectRefusal(refused);
    EXPECT_THAT(refused.err, HasSubstr("“a\\xff” is not UTF-8 text"));
  }
}

TEST(HostileTexts, AreTextInWhatAnImportSays) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "s.alidade").string();
  std::string all;
  for (const char c : allHostileTexts())
    if (std::string_view("\n\r\t;\"").find(c) == std::string_view::npos) all += c;
  const std::string head = "axis;point;horizontal;vertical;note;" + all + "\n";
  const std::string row = "0;" + all + ";10°00'00\";90°00'00\";" + all + ";" + all + "\n";
  const std::string gsi = "110001+00000001 21.322+37985926 22.322+09808000\n";
  const std::vector<std::string> contents = {
      head + row + "0;ZERO;10;90;" + all + ";1\n# 0;1;10;90;" + all + "\n",
      head + "0;1;" + all + ";90;;\n",
      "horizontal;vertical\n10;90;" + all + "\n",
      "horizontal;horizontal " + all + ";vertical\n",
      "horizontal;vertical;excluded\n10;90;" + all + "\n",
      "\"" + all,
      all,
      "410001+\x1b[31m\u202E\n" + gsi,
      "41....+\x1b[31mabc\n" + gsi,
      "#" + all + "\n" + gsi,
      "110001+\x1b]0;x\x07y 21.322+37985926 22.322+0980\x1b[31\n",
      gsi + "110001+" + all + "\n",
      "axis;point;horizontal;vertical;note\n0;1;10;90;caf\xE9 \x9b"
      "31m \x85\n",
  };
  for (const std::string& content : contents)
    for (const char* name : {"r.csv", "a\x1b[2J\u202E\u0085\n%1<b>&.csv", "a\xFF.csv"}) {
      const ProgramRun run = alidadeCli({"import", folder.file(name, content), "--out", out});
      EXPECT_THAT(run.exitCode, ::testing::AnyOf(0, 2)) << run.err;
      expectVisible(run, content);
      if (run.exitCode == 2) expectRefusal(run);
    }
  const ProgramRun kept = alidadeCli({"import", folder.file("r.csv", contents[0]), "--out", out});
  ASSERT_EQ(kept.exitCode, 0) << kept.err;
  const Json reading = Json::parse(contentOf(out))["positions"][0]["readings"][0];
  EXPECT_THAT(reading.at("note").get<std::string>(), HasSubstr("\x1b[2J"));
}

TEST(HostileTexts, AreTextInTheScoreOfTrialsMadeElsewhere) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "sessions");
  const std::string id = "a\x1b[2J\u202E\n\u0085<b>";
  folder.file("sessions/" + id + ".alidade", contentOf(paperSession));
  const auto scored = [&](const Json& truth, std::vector<std::string> more = {}) {
    folder.file("truth.json", Json({{id, truth}}).dump());
    more.insert(more.begin(), {"trial", "--score", folder.path().string()});
    return alidadeCli(more);
  };
  const std::string all = allHostileTexts();
  const Json good = {{"kind", all}, {"intersection_mm", 1}, {"protocol", all}};
  const ProgramRun text = scored(good), json = scored(good, {"--json"});
  EXPECT_EQ(text.exitCode, 0) << text.err;
  EXPECT_EQ(json.exitCode, 0) << json.err;
  expectVisible(text, "score");
  expectVisible(json, "score as JSON");
  EXPECT_EQ(Json::parse(json.out)["trials"][0]["id"], id);
  for (const Json& bad :
       {Json{{"kind", 1}}, Json{{"kind", "none"}, {"intersection_mm", 1}, {"causes", {all}}}}) {
    const ProgramRun run = scored(bad);
    expectRefusal(run);
    expectVisible(run, bad.dump());
  }
  folder.file("truth.json", "{\"a\xFF\": 1}");
  const ProgramRun noText = alidadeCli({"trial", "--score", folder.path().string()});
  expectRefusal(noText);
  EXPECT_THAT(noText.err, HasSubstr("is not UTF-8 text"));
}

}  // namespace
}  // namespace alidade::test
