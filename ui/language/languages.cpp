#include "ui/language/languages.h"

#include <QCoreApplication>
#include <QLocale>
#include <QSettings>
#include <algorithm>

#include "core/base/phrase.h"
#include "ui/language/interpreter.h"

namespace alidade::ui {

namespace {

const QString languageKey = QStringLiteral("language");

bool isOurs(const QString& id) {
  const auto& all = allLanguages();
  return std::any_of(all.begin(), all.end(), [&](const LanguageInfo& language) { return language.id == id; });
}

/// The first supported language in the desktop's list, else English. Traditional Chinese is not supported.
QString desktopLanguage() {
  for (const QString& wanted : QLocale::system().uiLanguages()) {
    const QLocale locale(wanted);
    if (locale.language() == QLocale::English || locale.language() == QLocale::C) break;
    if (locale.language() == QLocale::Chinese && locale.script() == QLocale::SimplifiedHanScript)
      return QStringLiteral("zh_CN");
  }
  return QStringLiteral("en");
}

std::string interpretedPhrase(const char* english) {
  return QCoreApplication::translate("Phrase", english).toStdString();
}

}  // namespace

const std::vector<LanguageInfo>& allLanguages() {
  static const std::vector<LanguageInfo> languages{{QStringLiteral("en"), QStringLiteral("English")},
                                                   {QStringLiteral("zh_CN"), QStringLiteral("简体中文")}};
  return languages;
}

QString languageOr(const QString& id) {
  return isOurs(id) ? id : desktopLanguage();
}

QString rememberedLanguage() {
  const QString id = QSettings().value(languageKey).toString();
  return isOurs(id) ? id : QString();
}

void rememberLanguage(const QString& id) {
  QSettings().setValue(languageKey, id);
}

void speak(const QString& id) {
  static Interpreter interpreter;
  Interpreter::setTongue(tongueOf(languageOr(id)));
  QCoreApplication::installTranslator(&interpreter);
  Phrase::setInterpreter(interpretedPhrase);
}

QString shownLanguage() {
  const Tongue* tongue = Interpreter::tongue();
  return tongue ? tongue->id : allLanguages().front().id;
}

LanguageScope::LanguageScope(const QString& id) : m_before(Interpreter::ownTongue()) {
  if (const Tongue* tongue = tongueOf(id)) Interpreter::ownTongue() = tongue;
}

LanguageScope::~LanguageScope() {
  Interpreter::ownTongue() = static_cast<const Tongue*>(m_before);
}

}  // namespace alidade::ui
