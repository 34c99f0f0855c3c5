#include "ui/language/interpreter.h"

#include <QLibraryInfo>
#include <atomic>

#include "ui/language/languages.h"

void initializeAlidadeLanguages() {
  Q_INIT_RESOURCE(languages);
}

namespace alidade::ui {

namespace {

std::atomic<const Tongue*> tongueOfProgram = nullptr;

std::vector<Tongue> loadedTongues() {
  initializeAlidadeLanguages();
  std::vector<Tongue> tongues;
  for (const LanguageInfo& language : allLanguages()) {
    Tongue& tongue = tongues.emplace_back(Tongue{.id = language.id, .texts = {}});
    for (const QString& file :
         {QStringLiteral(":/languages/alidade_") + language.id,
          QLibraryInfo::path(QLibraryInfo::TranslationsPath) + QStringLiteral("/qtbase_") + language.id}) {
      auto texts = std::make_unique<QTranslator>();
      if (texts->load(file)) tongue.texts.push_back(std::move(texts));
    }
  }
  return tongues;
}

}  // namespace

const Tongue* tongueOf(const QString& id) {
  static const std::vector<Tongue> tongues = loadedTongues();
  for (const Tongue& tongue : tongues)
    if (tongue.id == id) return &tongue;
  return nullptr;
}

QString Interpreter::translate(const char* context, const char* source, const char* disambiguation,
                               int n) const {
  const Tongue* current = tongue();
  if (!current) return {};
  for (const auto& texts : current->texts)
    if (const QString text = texts->translate(context, source, disambiguation, n); !text.isEmpty())
      return text;
  return {};
}

void Interpreter::setTongue(const Tongue* tongue) {
  tongueOfProgram = tongue;
}

const Tongue*& Interpreter::ownTongue() {
  thread_local const Tongue* own = nullptr;
  return own;
}

const Tongue* Interpreter::tongue() {
  return ownTongue() ? ownTongue() : tongueOfProgram.load();
}

}  // namespace alidade::ui
