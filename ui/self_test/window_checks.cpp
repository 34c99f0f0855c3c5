#include "ui/self_test/window_checks.h"

#include <QDir>
#include <QFile>
#include <QFontDatabase>
#include <QFontMetrics>
#include <QGuiApplication>

#include "core/base/phrase.h"
#include "core/base/sha256.h"
#include "core/self_test/references.h"
#include "ui/language/languages.h"
#include "ui/report/text_style.h"

namespace alidade::ui {

namespace {

constexpr auto inWindow = CheckGroup::Window;
constexpr const char* byWholeFile = PHRASE_LATER("Phrase", "SHA-256 of the whole file");

/// Compares the built-in files with the hashes of the installed files of the same name.
void addOwnFiles(std::vector<SelfCheck>& checks, const QString& folder, const std::string& installed) {
  for (const InstalledFile& file : installedFiles()) {
    if (!file.path.starts_with(installed)) continue;
    const std::string path(file.path.substr(installed.size()));
    QFile own(folder + QString::fromStdString(path));
    // The program contains only the samples of the start page.
    if (!own.exists() && folder.contains(QLatin1String("samples"))) continue;
    const std::string bytes = own.open(QIODevice::ReadOnly) ? own.readAll().toStdString() : std::string();
    checks.push_back(hashCheck(inWindow, own.fileName().toStdString(), std::string(file.sha256),
                               sha256(bytes), byWholeFile));
  }
}

/// Checks that the text "passed" is translated in each language, but stays as it is in English.
void addLanguages(std::vector<SelfCheck>& checks) {
  for (const LanguageInfo& language : allLanguages()) {
    const LanguageScope scope(language.id);
    const bool isEnglish = language.id == QLatin1String("en");
    const std::string found = Phrase::of("passed");
    const bool isAccessible = isEnglish == (found == "passed");
    checks.push_back({.group = inWindow,
                      .name = "language " + language.id.toStdString(),
                      .expected = isEnglish ? "passed" : "not English",
                      .found = found,
                      .reason = PHRASE_LATER("Phrase", "a word of this page, in that language"),
                      .outcome = isAccessible ? SelfCheck::Outcome::Passed : SelfCheck::Outcome::Failed});
  }
}

/// Says which letters of `text` the font family lacks, or that it has all of them.
std::string lacking(const QString& family, const QString& text) {
  if (!QFontDatabase::families().contains(family)) return "no such font";
  const QFontMetrics metrics{QFont(family)};
  QString missing;
  for (const QChar letter : text)
    if (!metrics.inFont(letter)) missing += letter;
  return missing.isEmpty() ? std::string("all letters") : "without " + missing.toStdString();
}

void addFonts(std::vector<SelfCheck>& checks) {
  constexpr const char* ofReports = PHRASE_LATER("Phrase", "letters of reports and charts");
  for (const QString& family : {reportFontFamily(), QStringLiteral("DejaVu Sans Mono")})
    checks.push_back(textCheck(inWindow, "font " + family.toStdString(), "all letters",
                               lacking(family, QStringLiteral("AZaz09ΔσχφαβλνΣ°′″±≤≥−·√²⁻")), ofReports));
  const QStringList chinese = QFontDatabase::families(QFontDatabase::SimplifiedChinese);
  checks.push_back(
      {.group = inWindow,
       .name = "font, Chinese",
       .expected = "one",
       .found = chinese.isEmpty() ? "none" : chinese.first().toStdString(),
       .reason = PHRASE_LATER("Phrase", "only a window or report in Chinese needs a Chinese font"),
       .outcome = !chinese.isEmpty()                           ? SelfCheck::Outcome::Passed
                  : shownLanguage() == QStringLiteral("zh_CN") ? SelfCheck::Outcome::Failed
                                                               : SelfCheck::Outcome::LeftOut});
}

}  // namespace

std::vector<SelfCheck> windowChecks() {
  std::vector<SelfCheck> checks;
  addOwnFiles(checks, QStringLiteral(":/samples/"), "alidade/samples/");
  addOwnFiles(checks, QStringLiteral(":/help/"), "doc/alidade/help/");
  addLanguages(checks);
  addFonts(checks);
  return checks;
}

}  // namespace alidade::ui
