#include <gmock/gmock.h>

#include <filesystem>
#include <pugixml.hpp>

#include "tests/console/console.h"
#include "tests/support/file_content.h"
#include "tests/support/hostile_session.h"

namespace alidade::test {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

/// Fills in every field that a certificate requires from a session.
void fillIn(Json& session) {
  session["measured_on"] = "2026-03-01";
  session["operator"] = "A. Li";
  session["place"] = "Hall 2";
  session["report"] = {{"number", "K-2026-17"},
                       {"laboratory", "Angle Laboratory, Long Street 1, 12345 Town"},
                       {"customer", "惯性系统研究所，长安街 5 号"},
                       {"authorised_by", "Dr. B. Ren"},
                       {"rule_agreed_by", "the customer"}};
  session["device"] = {{"name", "转台 7"}, {"serial", "G7"}};
  session["instrument"]["name"] = "TM5100A";
  session["instrument"]["serial"] = "99";
  session["instrument"]["certificate"] = "PTB 4711";
  session["environment"] = {{"temperature_c", 21.5}, {"sigma_temperature_c", 0.2}};
}

const std::vector<std::string> fullCall = {"--country",      "DE",      "--performed-at", "customer",
                                           "--manufacturer", "Arc Ltd", "--issued",       "2026-03-02"};

class CertificateTest : public ::testing::Test {
 protected:
  ProgramRun write(const std::string& session, std::vector<std::string> options = {}) {
    options.push_back("--draft");
    return writeWhole(session, options);
  }
  ProgramRun writeWhole(const std::string& session, std::vector<std::string> options) {
    options.insert(options.begin(), {"certificate", session, "--out", m_out});
    return alidadeCli(options);
  }

  /// The certificate, valid against the published schema.
  pugi::xml_document read() {
    const ProgramRun lint = runProgram({.program = "xmllint",
                                        .arguments = {"--nonet", "--noout", "--huge", "--schema",
                                                      ALIDADE_REFERENCE_DIR "/dcc/dcc_3_2_0.xsd", m_out}});
    EXPECT_EQ(lint.exitCode, 0) << lint.err;
    pugi::xml_document document;
    EXPECT_TRUE(document.load_file(m_out.c_str()));
    return document;
  }

  static pugi::xml_node byId(const pugi::xml_document& document, const std::string& id) {
    return document.select_node(("//*[@id='" + id + "']").c_str()).node();
  }

  /// Compares the numbers of a quantity with those of the fit, which are rounded to two digits of U.
  static void expectNumbers(const pugi::xml_document& document, const std::string& id, const Json& value,
                            const Json& uncertainty, const Json& coverage) {
    const pugi::xml_node real = byId(document, id).child("si:real");
    const std::string written = real.child_value("si:value");
    const pugi::xml_node expanded = real.child("si:expandedUnc"),
                         interval = real.child("si:coverageInterval");
    const double u = uncertainty.get<double>(), step = std::pow(10, std::floor(std::log10(u)) - 1);
    EXPECT_NEAR(std::stod(written), value.get<double>(), 0.51 * step) << id;
    EXPECT_LT(written.size(), 12u) << id;
    if (expanded)
      EXPECT_NEAR(std::stod(expanded.child_value("si:uncertainty")), u, 0.51 * step) << id;
    else
      EXPECT_EQ(std::string(interval.child_value("si:intervalMin")).find_first_not_of("0."),
                std::string::npos)
          << id;
    const pugi::xml_node stated = expanded ? expanded : interval;
    if (!coverage.is_null()) {
      EXPECT_EQ(std::stod(stated.child_value("si:coverageProbability")), coverage.get<double>()) << id;
    }
    EXPECT_EQ(real.child_value("si:unit"), std::string("\\milli\\metre"));
  }

  /// Compares a number without uncertainty with that of the fit; two decimals are stated.
  static void expectRounded(const pugi::xml_document& document, const std::string& id, const Json& value) {
    const pugi::xml_node quantity = byId(document, id);
    if (value.is_null()) {
      EXPECT_TRUE(quantity.child("dcc:noQuantity")) << id;
      return;
    }
    const std::string written = quantity.child("si:real").child_value("si:value");
    ASSERT_FALSE(written.empty()) << id;
    EXPECT_NEAR(std::stod(written), value.get<double>(), 0.0051) << id;
  }

  /// The contents of a file element, decoded by an external program.
  std::string decoded(const pugi::xml_node& file) {
    const ProgramRun run =
        runProgram({.program = "base64", .arguments = {"-d"}, .input = file.child_value("dcc:dataBase64")});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    return run.out;
  }

  static std::string conformity(const pugi::xml_document& document) {
    return byId(document, "conformity").child_value("dcc:conformity");
  }

  const TemporaryFolder m_folder;
  const std::string m_out = m_folder.path() / "certificate.xml";
};

Json fitted(const std::string& session) {
  return Json::parse(alidadeCli({"fit", session, "--json"}).out);
}

std::vector<std::string> sampleSessions() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(ALIDADE_SAMPLES_DIR))
    if (entry.path().extension() == ".alidade") files.push_back(entry.path());
  return files;
}

TEST_F(CertificateTest, ConformsAndSaysTheNumbersOfTheFitForEverySample) {
  for (const std::string& sample : sampleSessions()) {
    SCOPED_TRACE(sample);
    const ProgramRun run = write(sample, {"--measured-on", "2026-01-02"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const pugi::xml_document document = read();
    const Json fit = fitted(sample);
    const Json &found = fit["intersection_as_found"], &alone = fit["intersection"];
    expectNumbers(document, "intersection_as_measured", found["value_mm"], found["expanded_mm"],
                  found["coverage"]);
    expectNumbers(document, "intersection_of_fit", alone["value_mm"], alone["expanded_mm"],
                  alone["coverage"]);
    expectNumbers(document, "in_plane", alone["in_plane_mm"], alone["in_plane_expanded_mm"],
                  alone["coverage"]);
    for (const Json& arc : fit["arcs"]) {
      const std::string id = "arc_" + std::to_string(arc["axis_deg"].get<int>());
      expectNumbers(document, id + "_x", arc["center_mm"]["x"], arc["sigma_mm"]["x"], {});
      expectNumbers(document, id + "_y", arc["center_mm"]["y"], arc["sigma_mm"]["y"], {});
      expectNumbers(document, id + "_radius", arc["radius_mm"], arc["sigma_mm"]["radius"], {});
      expectRounded(document, id + "_sightings", arc["readings"]);
      expectRounded(document, id + "_residual_rms", arc["residual_rms_arcsec"]);
      expectRounded(document, id + "_reduced_chi_square", arc["reduced_chi2"]);
      expectRounded(document, id + "_redundancy", arc["degrees_of_freedom"]);
    }
    for (const auto& [id, key] :
         {std::pair("across_plane", "across_plane"), std::pair("distance_from_axis", "distance_from_axis")})
      if (fit[key].is_null()) {
        EXPECT_TRUE(byId(document, id).child("dcc:noQuantity"));
      } else {
        expectNumbers(document, id, fit[key]["value_mm"], fit[key]["expanded_mm"], found["coverage"]);
      }
    const double k = std::stod(byId(document, "intersection_of_fit")
                                   .child("si:real")
                                   .child("si:expandedUnc")
                                   .child_value("si:coverageFactor"));
    EXPECT_NEAR(k, alone["coverage_factor"].get<double>(), 6e-4);
  }
}

TEST_F(CertificateTest, HoldsSessionResultsAndReportByteForByte) {
  std::string pdf = "%PDF-1.7\n";
  for (int i = 0; i < 1000; ++i) pdf += static_cast<char>(i * 7 % 256);
  const std::string report = m_folder.file("report 1.pdf", pdf);
  const ProgramRun run = write(paperSession, {"--measured-on", "2026-01-02", "--pdf", report});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const pugi::xml_document document = read();
  const auto files = document.select_nodes("//dcc:measurementResult/dcc:description/dcc:file");
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].node().child_value("dcc:fileName"), std::string("paper-table-1.alidade"));
  EXPECT_EQ(files[0].node().child_value("dcc:mimeType"), std::string("application/x-alidade-session"));
  EXPECT_EQ(decoded(files[0].node()), contentOf(paperSession));
  EXPECT_EQ(files[1].node().child_value("dcc:fileName"), std::string("results.json"));
  EXPECT_EQ(Json::parse(decoded(files[1].node())), fitted(paperSession));
  const pugi::xml_node embedded = document.child("dcc:digitalCalibrationCertificate").child("dcc:document");
  EXPECT_EQ(embedded.child_value("dcc:fileName"), std::string("report 1.pdf"));
  EXPECT_EQ(embedded.child_value("dcc:mimeType"), std::string("application/pdf"));
  EXPECT_EQ(decoded(embedded), pdf);
}

TEST_F(CertificateTest, SaysWhatTheSessionStatesAndLeavesNothingOpen) {
  const std::string session = m_folder.file("full.alidade", changedPaperSession(fillIn));
  const ProgramRun run = writeWhole(session, fullCall);
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_EQ(run.err, "") << "nothing is left empty";
  const pugi::xml_document document = read();
  const auto text = [&](const char* path) {
    return std::string(document.select_node(path).node().text().get());
  };
  EXPECT_EQ(text("//dcc:uniqueIdentifier"), "K-2026-17");
  EXPECT_EQ(text("//dcc:countryCodeISO3166_1"), "DE");
  EXPECT_EQ(text("//dcc:beginPerformanceDate"), "2026-03-01");
  EXPECT_EQ(text("//dcc:issueDate"), "2026-03-02");
  EXPECT_EQ(text("//dcc:performanceLocation"), "customer");
  EXPECT_EQ(text("//dcc:item/dcc:name/dcc:content"), "转台 7");
  EXPECT_EQ(text("//dcc:item/dcc:manufacturer/dcc:name/dcc:content"), "Arc Ltd");
  EXPECT_EQ(text("//dcc:item/dcc:identifications/dcc:identification/dcc:value"), "G7");
  EXPECT_EQ(text("//dcc:calibrationLaboratory//dcc:name/dcc:content"), "Angle Laboratory");
  EXPECT_EQ(text("//dcc:calibrationLaboratory//dcc:further/dcc:content"), "Long Street 1, 12345 Town");
  EXPECT_EQ(text("//dcc:customer/dcc:name/dcc:content"), "惯性系统研究所");
  EXPECT_EQ(text("//dcc:customer//dcc:further/dcc:content"), "长安街 5 号");
  EXPECT_EQ(text("//dcc:respPerson[1]//dcc:content"), "Dr. B. Ren");
  EXPECT_EQ(text("//dcc:respPerson[2]//dcc:content"), "A. Li");
  EXPECT_EQ(text("//dcc:measuringEquipment/dcc:name/dcc:content"), "TM5100A");
  EXPECT_EQ(text("//dcc:measuringEquipment//dcc:identification[2]/dcc:value"), "PTB 4711");
  const pugi::xml_node temperature = byId(document, "temperature").child("si:real");
  EXPECT_EQ(temperature.child_value("si:value"), std::string("21.5"));
  EXPECT_EQ(temperature.child_value("si:unit"), std::string("\\degreecelsius"));
  EXPECT_EQ(temperature.child("si:expandedUnc").child_value("si:uncertainty"), std::string("0.2"));
  EXPECT_FALSE(byId(document, "not_stated"));
}

TEST_F(CertificateTest, IsNotMadeWithoutWhatItMustState) {
  const ProgramRun run = writeWhole(paperSession, {"--measured-on", "2026-01-02"});
  expectRefusal(run);
  for (const char* noun : {"report number", "country", "laboratory", "customer", "authorised by", "--draft"})
    EXPECT_THAT(run.err, HasSubstr(noun));
  EXPECT_FALSE(std::filesystem::exists(m_out));
  // Leaves out one entry at a time.
  for (const auto& entry :
       {std::pair("report", "number"), std::pair("report", "laboratory"), std::pair("report", "customer"),
        std::pair("report", "authorised_by"), std::pair("device", "name"), std::pair("device", "serial")}) {
    const std::string session = m_folder.file("lacks.alidade", changedPaperSession([&](Json& json) {
                                                fillIn(json);
                                                json[entry.first].erase(entry.second);
                                              }));
    expectRefusal(writeWhole(session, fullCall));
  }
  const std::string session = m_folder.file("full.alidade", changedPaperSession(fillIn));
  expectRefusal(writeWhole(session, {"--country", "DE"}));
  EXPECT_EQ(writeWhole(session, fullCall).exitCode, 0);
}

TEST_F(CertificateTest, SaysNothingInternal) {
  ASSERT_EQ(write(paperSession, {"--measured-on", "2026-01-02"}).exitCode, 0);
  const pugi::xml_document document = read();
  for (const auto& node : document.select_nodes("//dcc:content[@lang]"))
    for (const char* word : {"session", "schema", "catalogue ", "_"})
      EXPECT_EQ(std::string(node.node().text().get()).find(word), std::string::npos)
          << node.node().text().get();
  EXPECT_EQ(byId(document, "distance_from_axis").select_node(".//si:distribution").node().text().get(),
            std::string("Rice"));
}

TEST_F(CertificateTest, ListsWhatIsEmptyInOneSentenceAndMakesNothingUp) {
  const ProgramRun run = write(paperSession, {"--measured-on", "2026-01-02"});
  EXPECT_EQ(run.exitCode, 0);
  EXPECT_EQ(std::ranges::count(run.err, '\n'), 1) << run.err;
  for (const char* noun :
       {"report number", "country", "laboratory", "customer", "device serial number", "authorised by"})
    EXPECT_THAT(run.err, HasSubstr(noun));
  const pugi::xml_document document = read();
  EXPECT_EQ(byId(document, "guideway").child("dcc:identifications").first_child().child_value("dcc:value"),
            std::string("not stated"));
  EXPECT_THAT(document.select_node("//dcc:uniqueIdentifier").node().text().get(),
              ::testing::StartsWith("urn:alidade:session:sha256:"));
  EXPECT_FALSE(document.select_node("//dcc:issueDate"));
  EXPECT_TRUE(byId(document, "not_stated"));
}

TEST_F(CertificateTest, SaysWhatStandsForNoneOnlyWhereNothingIsStated) {
  const auto notStated = [&](const std::vector<std::string>& more) {
    std::vector<std::string> call{"--measured-on", "2026-01-02"};
    call.insert(call.end(), more.begin(), more.end());
    EXPECT_EQ(write(paperSession, call).exitCode, 0);
    const pugi::xml_document document = read();
    std::string text;
    for (const auto& content : byId(document, "not_stated").select_nodes(".//dcc:declaration//text()"))
      text += content.node().value();
    return text;
  };
  EXPECT_THAT(notStated({}), testing::AllOf(HasSubstr("Country ZZ means “not stated”"),
                                            HasSubstr("Place “other” means “not stated”")));
  EXPECT_THAT(notStated({"--country", "DE"}),
              testing::AllOf(HasSubstr("Place “other”"), testing::Not(HasSubstr("ZZ"))));
  EXPECT_THAT(notStated({"--country", "DE", "--performed-at", "laboratory"}),
              testing::Not(HasSubstr("means “not stated”")));
}

TEST_F(CertificateTest, HasTheSameBytesEachTime) {
  ASSERT_EQ(write(paperSession, {"--measured-on", "2026-01-02"}).exitCode, 0);
  const std::string first = contentOf(m_out);
  ASSERT_EQ(write(paperSession, {"--measured-on", "2026-01-02"}).exitCode, 0);
  EXPECT_EQ(contentOf(m_out), first);
}

// The verdict of the fit in the schema's words: an undecided one is never a pass.
TEST_F(CertificateTest, StatesConformityAsTheVerdictHasIt) {
  std::set<std::string> seen;
  const Json fit = fitted(paperSession);
  const double value = fit["intersection_as_found"]["value_mm"];
  for (const double tolerance : {0.01, 0.3, 0.9, 1.2, 1.35, 1.6, 1.9, 2.03, 2.5, 9.0}) {
    SCOPED_TRACE(tolerance);
    for (const char* measurand : {"intersection", "distance"}) {
      const std::string session = m_folder.file("tolerance.alidade", changedPaperSession([&](Json& json) {
                                                  json["measured_on"] = "2026-01-02";
                                                  json["acceptance"]["tolerance_mm"] = tolerance;
                                                  json["acceptance"]["measurand"] = measurand;
                                                }));
      ASSERT_EQ(write(session).exitCode, 0);
      const std::string word = conformity(read()), verdict = fitted(session)["decision"]["verdict"];
      seen.insert(word);
      // A conditional verdict needs a conditional statement.
      const std::string declaration =
          byId(read(), "conformity").select_node("dcc:declaration/dcc:content").node().text().get();
      const bool isConditional = declaration.find("only if the cause is") != std::string::npos ||
                                 declaration.find("holds only if") != std::string::npos;
      if (verdict == "accept") {
        EXPECT_EQ(word, isConditional ? "conditionalPass" : "pass");
      }
      if (verdict == "reject") {
        EXPECT_EQ(word, isConditional ? "conditionalFail" : "fail");
      }
      if (verdict == "undecided") {
        EXPECT_THAT(word, ::testing::AnyOf("conditionalPass", "conditionalFail", ""));
      }
      if (measurand == std::string("intersection") && word == "conditionalPass") {
        EXPECT_LE(value, tolerance);
      }
      if (measurand == std::string("intersection") && word == "conditionalFail") {
        EXPECT_GT(value, tolerance);
      }
    }
  }
  // Sessions with Δd of 3 mm, whose verdict is unconditional.
  for (const auto& [tolerance, word] : {std::pair("1", "fail"), std::pair("6", "pass")}) {
    const std::string session = m_folder.path() / "drawn.alidade";
    alidadeCli({"simulate", "--out", session, "--truth", m_folder.path() / "truth.json", "--protocol",
                "two-face", "--seed", "3", "--intersection", "3", "--tolerance", tolerance, "--measured-on",
                "2026-01-02"});
    ASSERT_EQ(write(session).exitCode, 0);
    EXPECT_EQ(conformity(read()), word);
    seen.insert(word);
  }
  EXPECT_THAT(seen, ::testing::IsSupersetOf({"pass", "fail", "conditionalPass", "conditionalFail"}));
}

TEST_F(CertificateTest, MakesNoStatementWithoutToleranceCoverageOrSecondPosition) {
  const auto written = [&](const std::function<void(Json&)>& change) {
    const std::string session = m_folder.file("changed.alidade", changedPaperSession([&](Json& json) {
                                                json["measured_on"] = "2026-01-02";
                                                change(json);
                                              }));
    const ProgramRun run = write(session);
    EXPECT_EQ(run.exitCode, 0) << run.err;
    return read();
  };
  const auto without = written([](Json& json) { json["acceptance"].erase("tolerance_mm"); });
  EXPECT_EQ(conformity(without), "");
  EXPECT_FALSE(byId(without, "tolerance"));
  const auto half = written([](Json& json) { json["acceptance"]["coverage"] = 0.5; });
  EXPECT_EQ(conformity(half), "");
  const pugi::xml_node interval =
      byId(half, "intersection_of_fit").child("si:real").child("si:coverageInterval");
  EXPECT_TRUE(interval) << "the schema has no coverage factor below 1";
  const auto one = written([](Json& json) { json["positions"].erase(1); });
  EXPECT_EQ(conformity(one), "");
  EXPECT_FALSE(byId(one, "intersection"));
  EXPECT_TRUE(byId(one, "arc_0_radius"));
  const auto again = written([](Json& json) { json["positions"].push_back(json["positions"][0]); });
  EXPECT_TRUE(byId(again, "arc_0_2_radius"));
}

TEST_F(CertificateTest, HoldsWhateverIsTypedAsTextOfAnXmlFile) {
  std::vector<std::string> texts{allHostileTexts(), "]]>",          "<!-- & -->",
                                 " \t\n ",          "\uFFFE\uFFFF", "“质量”，日期"};
  for (const HostileText& hostile : hostileTexts) texts.emplace_back(hostile.text);
  for (const std::string& text : texts) {
    SCOPED_TRACE(text);
    const std::string session =
        m_folder.file("hostile.alidade", hostileSession(contentOf(paperSession), text));
    const ProgramRun run = write(session, {"--measured-on", "2026-01-02"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const pugi::xml_document document = read();
    EXPECT_EQ(firstForbidden(contentOf(m_out)), std::nullopt);
    EXPECT_EQ(decoded(document.select_nodes("//dcc:file")[0].node()), contentOf(session));
  }
}

TEST_F(CertificateTest, RefusesInASentenceWhatItCannotSay) {
  const auto refused = [&](const std::vector<std::string>& options, const char* because) {
    const ProgramRun run = write(paperSession, options);
    expectRefusal(run);
    EXPECT_THAT(run.err, HasSubstr(because));
    EXPECT_FALSE(std::filesystem::exists(m_out));
  };
  refused({}, "measured_on");
  refused({"--measured-on", "yesterday"}, "yesterday");
  refused({"--measured-on", "2026-02-01", "--issued", "2026-01-31"}, "before the measurement");
  refused({"--measured-on", "2026-02-01", "--issued", "soon"}, "soon");
  refused({"--measured-on", "2026-02-01", "--country", "Germany"}, "ISO 3166-1");
  refused({"--measured-on", "2026-02-01", "--performed-at", "home"}, "performed-at");
  refused({"--measured-on", "2026-02-01", "--pdf", paperSession}, "no PDF");
  refused({"--measured-on", "2026-02-01", "--pdf", m_folder.path() / "none.pdf"}, "none.pdf");
  expectRefusal(alidadeCli({"certificate", paperSession, "--measured-on", "2026-02-01", "--out", "-"}));
  const std::string session = m_folder.file("own.alidade", contentOf(paperSession));
  expectRefusal(alidadeCli({"certificate", session, "--measured-on", "2026-02-01", "--out", session}));
  EXPECT_EQ(contentOf(session), contentOf(paperSession));
}

}  // namespace
}  // namespace alidade::test
