#include "ui/import/import_source.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <utility>

#include "core/base/file_bytes.h"
#include "core/base/sha256.h"
#include "core/exchange/file_format.h"
#include "ui/document/encoded_path.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

struct SourceText {
  Q_DECLARE_TR_FUNCTIONS(SourceText)
};

QStringList suffixes() {
  QStringList all;
  for (const std::string_view suffix : readingsSuffixes())
    all << QString::fromUtf8(suffix.data(), static_cast<qsizetype>(suffix.size()));
  return all;
}

Problem refusal(const QString& name, const Problem& why) {
  return {SourceText::tr("“%1” cannot be imported.\n\n%2")
              .arg(visibleLine(name), visibleLine(why.text()))
              .toStdString()};
}

Result<ImportSource> sourceOf(const QString& name, const QString& title, std::string bytes) {
  const Result<std::string> text = readingsText(bytes, name.toStdString());
  if (!text) return refusal(name, text.problem());
  Result<Recognised> recognised = recognise(*text);
  if (!recognised) return refusal(name, recognised.problem());
  std::string digest = sha256(bytes);
  return ImportSource{.name = name,
                      .title = title,
                      .bytes = std::make_shared<const std::string>(std::move(bytes)),
                      .sha256 = std::move(digest),
                      .recognised = *std::move(recognised)};
}

}  // namespace

Result<std::vector<ImportSource>> readSources(const QStringList& paths) {
  std::vector<ImportSource> sources;
  for (const QString& path : paths) {
    const QFileInfo file(path);
    Result<std::string> bytes = readFile(encodedPath(path));
    if (!bytes) return refusal(file.fileName(), bytes.problem());
    Result<ImportSource> source = sourceOf(file.fileName(), file.completeBaseName(), *std::move(bytes));
    if (!source) return source.problem();
    sources.push_back(*std::move(source));
  }
  return sources;
}

Result<std::vector<ImportSource>> textSource(const QString& name, const std::string& text) {
  Result<ImportSource> source = sourceOf(name, {}, text);
  if (!source) return source.problem();
  return std::vector{*std::move(source)};
}

bool isReadingsFile(const QString& path) {
  return isImportedSuffix(QFileInfo(path).suffix().toStdString());
}

QString readingsPatterns() {
  QStringList patterns;
  for (const QString& suffix : suffixes())
    patterns << QStringLiteral("*.") + suffix << QStringLiteral("*.") + suffix.toUpper();
  return patterns.join(u' ');
}

}  // namespace alidade::ui
