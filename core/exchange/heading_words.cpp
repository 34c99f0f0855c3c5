#include "core/exchange/heading_words.h"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "core/base/utf8.h"
#include "core/exchange/words.h"

namespace alidade {

namespace {

struct RoleWords {
  HeadingRole role;
  std::string_view words;  ///< separated by blanks; English, German, Chinese, Spanish, French, Russian
};

/// All known heading words in all languages, without regard to case and accents.
constexpr RoleWords vocabulary[] = {
    {HeadingRole::Axis,
     "axis position pos axisposition rotation Achse Achslage Achsstellung Achsposition 轴位 轴位置 轴 位置 "
     "eje posición axe ось положение"},
    {HeadingRole::Turn, "turn"},
    {HeadingRole::Station,
     "station stn standpoint setup Standpunkt Stp Aufstellung 测站 测站点 站点 站号 estación est станция "
     "стояния"},
    {HeadingRole::Point,
     "point points pt pts ptno ptid pointno pointid target targets # "
     "Punkt Punkte Pkt PktNr PunktNr Punktnummer Ziel Zielpunkt Zielpkt ZP Zielpunktnummer Messpunkt "
     "Zielmarke "
     "点号 点名 点 测点 测点号 目标 目标点 目标点号 照准点 照准点号 照准目标 观测点 点位 "
     "punto puntos pto ptos objetivo visado visée visé cible "
     "точка точки тчк т пункт пункта цель визирования визир визирная визирования"},
    {HeadingRole::Numbering,
     "no nr num nro number id name n n° Nummer Bezeichnung lfd 序号 编号 号 名称 nombre número numéro nom "
     "номер имя"},
    {HeadingRole::Round,
     "round rounds set sets series Satz Sätze Runde Reihe 测回 测回号 测回数 回 ronda vuelta serie série "
     "tour прием "
     "приемы приема"},
    {HeadingRole::Face,
     "face side Lage Kreislage Fernrohrlage KL 盘位 镜位 盘 竖盘位置 度盘位置 cara положениекруга"},
    {HeadingRole::CircleWord, "circle cercle круг круга кругу círculo circ Kreis"},
    {HeadingRole::SpanishCircle, "cara círculo posición circ"},
    {HeadingRole::Horizontal,
     "horizontal horizontals hz ha hor horiz alpha α direction directions Richtung Richtungen "
     "Horizontalwinkel "
     "Horizontalrichtung Horizontalkreis Horizontalablesung Horizontalkreisablesung HzWinkel HzRichtung "
     "HzKreis "
     "Hzablesung HWinkel "
     "水平角 水平 水平盘 水平度盘 水平方向 水平方向值 方向值 方向 hor horizontales horizontale horizontalc "
     "dirección direcciones горизонтальный горизонтальная горизонтальные горизонтального горизонтальному "
     "горизонтальное горизонт гориз гор гк гу направление направления"},
    {HeadingRole::MaybeHorizontal, "h"},
    {HeadingRole::Vertical,
     "vertical verticals v va vert beta β vz Vertikal Vertikalwinkel Vertikalkreis Vertikalablesung VWinkel "
     "VKreis "
     "Vertikalkreisablesung 竖直角 竖盘 垂直角 垂直盘 垂直度盘 竖直盘 竖直度盘 竖直 垂直 竖角 "
     "verticales verticale вертикальный вертикальная вертикальные вертикального вертикальному верт вк ву"},
    {HeadingRole::MaybeVertical, "z"},
    {HeadingRole::Zenith,
     "zenith zenithdistance zd zen za Zenit Zenitwinkel Zenitdistanz Zenitabstand Zenith zenithwinkel 天顶距 "
     "天顶角 "
     "天顶 cenital cenitales cénit zénital zénithal zénithale zénith "
     "зенит зенитное зенитный зенитного зенитные"},
    {HeadingRole::Elevation,
     "elevation altitude Höhenwinkel Hoehenwinkel Höhenwkl 高度角 仰角 elevación élévation наклона"},
    {HeadingRole::Slider,
     "slider carriage Schlitten Schieber 滑块 滑座 deslizador curseur chariot ползун каретка φ phi"},
    {HeadingRole::Distance,
     "distance dist slopedist slopedistance sd sdist s d slope Strecke Strecken Distanz Schrägstrecke "
     "Schraegstrecke "
     "Schrägdistanz Schraegdistanz 斜距 距离 distancia дистанция расстояние"},
    {HeadingRole::HorizontalDistance,
     "hd hdist hordist Horizontalstrecke Horizontaldistanz Horizontalabstand 平距 水平距离 проложение "
     "reducida"},
    {HeadingRole::DistanceWord,
     "slope slant inclined inclinada geométrica geom inclinée наклонное наклонная schräg schraeg in"},
    {HeadingRole::Corrections, "corrections"},
    {HeadingRole::Excluded,
     "excluded exclude skip ausgeschlossen ausschließen 剔除 排除 excluido excluida exclu exclue исключено "
     "исключен"},
    {HeadingRole::Note,
     "note notes remark remarks comment comments Bemerkung Bemerkungen Anmerkung Anmerkungen Notiz Notizen "
     "Kommentar "
     "备注 注 注释 说明 observaciones observación nota notas comentario remarque remarques commentaire "
     "примечание "
     "примечания комментарий"},
    {HeadingRole::Tilt, "tilt incline inclination"},
    {HeadingRole::CrossTilt, "cross transverse"},
    {HeadingRole::LengthTilt, "length longitudinal"},
    {HeadingRole::Arcseconds, "arcsec arcseconds \""},
    {HeadingRole::Gon, "gon gons g gr gd ngrad neugrad grads grades 哥恩 冈 гон гоны"},
    {HeadingRole::Degrees,
     "deg degs degree degrees ° dd decdeg decimaldegrees Dezimalgrad Altgrad 度 十进制度 grado grados "
     "sexagesimal degré "
     "degrés град градус градусы градусов градусах"},
    {HeadingRole::Grad, "grad"},
    {HeadingRole::Radians, "rad radian radians Radiant 弧度 radianes радиан рад"},
    {HeadingRole::Dms, "dms gms gmss dmmss mmss ddmmss dddmmss 度分秒 гмс"},
    {HeadingRole::DegreePart,
     "deg degs degree degrees d dd ddd ° 度 grad grado grados degré degrés град градус градусы градусов g "
     "gon gr"},
    {HeadingRole::MinutePart,
     "min mins minute minutes m mm ' Minuten 分 minuto minutos мин минут минута минуты мн arcmin"},
    {HeadingRole::SecondPart,
     "sec secs second seconds s \" Sek Sekunde Sekunden 秒 segundo segundos seg ss seconde secondes сек "
     "секунд секунда "
     "секунды с arcsec"},
    {HeadingRole::GonMinutePart, "c cgon"},
    {HeadingRole::GonSecondPart, "cc"},
    {HeadingRole::FaceOne,
     "i 1 l left fl f1 cl cg links linke 盘左 正镜 左 左盘 izquierda izquierdo directo direct directa gauche "
     "кл лево лп "
     "левый ci1 faceleft"},
    {HeadingRole::FaceTwo,
     "ii 2 r right fr f2 cr rechts rechte 盘右 倒镜 右 右盘 derecha derecho inverso inverse inversa reverse "
     "droite droit кп "
     "право правый faceright"},
    {HeadingRole::Metre, "m metre metres meter meters 米 metro metros mètre mètres м метр метры метров"},
    {HeadingRole::Millimetre, "mm 毫米 мм"},
    {HeadingRole::Filler,
     "angle angles circle reading readings of the typed observed measured raw coordinate Winkel Kreis "
     "Ablesung "
     "Ablesungen Messwert Messwerte gemessen der die das des am in 读数 观测值 观测 值 角 角度 盘读数 度盘 "
     "度盘读数 "
     "ángulo ángulos lectura lecturas círculo limbo de del la el lecture lectures cercle du au le les "
     "угол угла углы круг круга кругу отсчет отсчеты по значение измеренный"},
};

class Vocabulary {
 public:
  static const Vocabulary& instance() {
    static const Vocabulary all;
    return all;
  }

  bool has(HeadingRole role, std::string_view word) const {
    return m_words.at(role).contains(std::string(word));
  }

  /// The length in bytes of the longest known word at the start of unspaced text; 0 if none matches.
  std::size_t longestAt(std::string_view text) const {
    for (std::size_t length = std::min(text.size(), m_longest); length > 0; --length)
      if (m_unparted.contains(std::string(text.substr(0, length)))) return length;
    return 0;
  }

 private:
  Vocabulary() {
    for (const RoleWords& entry : vocabulary) {
      std::istringstream words{foldedText(entry.words)};
      for (std::string word; words >> word;) {
        m_words[entry.role].insert(word);
        if (firstCharacter(word).code < 0x2E80) continue;
        m_longest = std::max(m_longest, word.size());
        m_unparted.insert(word);
      }
    }
  }

  std::map<HeadingRole, std::set<std::string>> m_words;
  std::set<std::string> m_unparted;  ///< words of scripts written without blanks
  std::size_t m_longest = 0;
};

/// Splits a heading into words, character by character.
class HeadingWords {
 public:
  std::vector<std::string> of(std::string_view heading) {
    const std::string folded = foldedText(heading);
    std::string_view rest = folded;
    while (!rest.empty()) rest.remove_prefix(take(rest));
    return std::move(m_words);
  }

 private:
  /// Takes the next word or sign; the result is its length in bytes.
  std::size_t take(std::string_view rest) {
    constexpr std::string_view punctuation = " _-.,;:/\\|()[]{}<>=*+!?&~", signs = "'\"#";
    const Utf8Character character = firstCharacter(rest);
    const std::string_view text = rest.substr(0, character.length);
    if (rest.starts_with("''")) return add("\"", 2);
    if (rest.starts_with("n°")) return m_isInWord ? append(text) : add("n°", 3);
    if (text == "°" || signs.find(text) != std::string_view::npos) return add(text, text.size());
    if (punctuation.find(text) != std::string_view::npos) return end(text.size());
    if (character.code < 0x2E80) return append(text);
    const std::size_t known = Vocabulary::instance().longestAt(rest);
    return known > 0 ? add(rest.substr(0, known), known) : add(text, text.size());
  }

  std::size_t append(std::string_view text) {
    if (!m_isInWord) m_words.emplace_back();
    m_isInWord = true;
    m_words.back() += text;
    return text.size();
  }
  std::size_t add(std::string_view word, std::size_t length) {
    m_words.emplace_back(word);
    return end(length);
  }
  std::size_t end(std::size_t length) {
    m_isInWord = false;
    return length;
  }

  std::vector<std::string> m_words;
  bool m_isInWord = false;
};

}  // namespace

bool means(HeadingRole role, std::string_view word) {
  return Vocabulary::instance().has(role, word);
}

std::vector<std::string> headingWords(std::string_view heading) {
  return HeadingWords().of(heading);
}

}  // namespace alidade
