"""Detection of texts in languages other than English, by script or else by function words.

A text in Latin script is compared with the frequent function words of each language: articles,
prepositions, conjunctions, numbers, and the few nouns that every table has. The text is foreign
only if those of one language outweigh the English ones. Foreign names of dishes or brands in an
English text therefore do not count.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping, Sequence
from functools import cache
from types import MappingProxyType

from ..syntax.text.tokens import small_words
from .dictionary import entry_of, is_english

_TABLES: Mapping[str, str] = MappingProxyType(
    {
        "German": "der die das den dem des ein eine einen einem einer und mit auf unter über neben "
        "hinter vor zwischen aus für von im am zur ist sind steht liegt stehen liegen links rechts "
        "davon daneben darauf zwei drei vier fünf oder kein keine runder tisch schreibtisch tasse "
        "tassen buch bücher teller schüssel rote roter rotes",
        "French": "le la les un une des du de et avec sur sous dans à au aux est sont il y devant "
        "derrière entre côté gauche droite deux trois quatre cinq ou sans pour table bureau tasse "
        "tasses livre livres assiette bol rouge posé posée près",
        "Spanish": "el la los las un una unos unas del de y con en sobre bajo al es son hay está "
        "están junto lado izquierda derecha delante detrás entre dos tres cuatro cinco sin para "
        "mesa escritorio taza tazas libro libros plato cuenco rojo roja encima",
        "Italian": "il lo la gli le un uno una del della dei delle di e con su sul sulla sulle nel "
        "nella in al alla è sono accanto sinistra destra davanti dietro tra due tre quattro cinque "
        "senza per tavolo scrivania tazza tazze libro libri piatto ciotola rosso rossa sopra",
        "Portuguese": "o os as um uma uns umas do da dos das de e com em no na nos nas sobre ao à "
        "é são há está ao lado esquerda direita frente atrás entre dois duas três quatro cinco sem "
        "para mesa secretária caneca xícara livro livros prato tigela vermelho vermelha cima",
        "Dutch": "de het een en met op van naast onder achter voor tussen in is zijn staat ligt "
        "links rechts twee drie vier vijf of zonder geen tafel bureau kop mok boek boeken bord kom "
        "rode ronde uit",
        "Swedish": "en ett den det och med på av bredvid under över bakom framför mellan är står "
        "ligger till vänster höger två tre fyra fem eller utan för bord skrivbord mugg kopp bok "
        "böcker tallrik skål röd röda om",
        "Danish": "en et den det og med på af ved siden under over bag foran mellem er står ligger "
        "til venstre højre to tre fire fem eller uden for bord skrivebord krus kop bog bøger "
        "tallerken skål rød røde",
        "Norwegian": "en ei et den det og med på av ved siden under over bak foran mellom er står "
        "ligger til venstre høyre to tre fire fem eller uten for bord skrivebord krus kopp bok "
        "bøker tallerken bolle rød røde",
        "Finnish": "ja on jolla pöytä pöydällä kirjoituspöytä vieressä alla takana edessä välissä "
        "vasemmalla oikealla puolella kaksi kolme neljä viisi tai ilman kuppi muki kirja kirjaa "
        "lautanen kulho punainen päällä",
        "Polish": "i z ze na w we pod nad obok za przed między jest są stoi leży lewej prawej "
        "stronie po od dwa dwie dwoma trzy cztery pięć lub bez dla stół biurko kubek kubki książka "
        "książki talerz miska czerwony",
        "Czech": "a s se na v ve pod nad vedle za před mezi je jsou stojí leží vlevo vpravo od u "
        "dva dvě dvěma tři čtyři pět nebo bez pro stůl stole hrnek kniha knihy talíř miska "
        "červený psací",
        "Hungarian": "egy és a az van mellett alatt fölött mögött előtt között bal jobb oldalán "
        "két három négy öt vagy nélkül asztal asztalon íróasztal bögre könyv tányér tál piros",
        "Romanian": "un o și cu pe în din la de lângă sub peste între este sunt stânga dreapta "
        "spatele fața doi două trei patru cinci sau fără pentru masă birou cană carte cărți "
        "farfurie bol roșu roșie al",
        "Turkish": "bir ve ile üzerinde altında yanında arkasında önünde solunda sağında arasında "
        "var olan iki üç dört beş veya için masa masada bardak kupa kitap tabak kase kırmızı",
        "Indonesian": "sebuah dan dengan di atas bawah samping sebelah kiri kanan depan belakang "
        "antara ada yang dari dua tiga empat lima atau tanpa untuk meja cangkir buku piring "
        "mangkuk merah",
        "Vietnamese": "một cái và với trên dưới bên cạnh trái phải trước sau giữa có của hai ba "
        "bốn năm hoặc không cho bàn cốc quyển sách đĩa bát đỏ",
        "Chinese": "一个 一台 一张 两个 三个 和 与 在 有 的 桌子上",
        "Japanese": "と の は に が を",
        "Hindi": "और एक",
        "Russian": "и с на в один два",
    }
)  # fmt: skip

_IN_NAMES = frozenset(
    {"de", "la", "le", "el", "du", "di", "da", "al", "au", "aux", "à", "con", "los", "las", "van",
     "den", "et", "os", "uno"}
)  # fmt: skip
"""Foreign words that occur in English texts, in names of dishes, brands and places."""

_QUOTED = re.compile(r"(?<!\w)['\"‘“«„].*?['\"’”»“](?!\w)")
_WORD = re.compile(r"[^\W\d_]+")
_DENSE = ("CJK", "HIRAGANA", "KATAKANA", "HANGUL")  # scripts whose characters are syllables
_SHARE = 1.5  # minimum ratio of foreign to English function words in a foreign text
_KNOWN = 0.25  # weight of a word in the English dictionary


def is_foreign(text: str) -> bool:
    """Return whether a text is in another language; False if this cannot be decided."""
    return is_in_other_script(text) or _is_in_other_words(_QUOTED.sub(" ", text))


def is_in_other_script(text: str) -> bool:
    """Return whether more of a text is written in other scripts than in Latin script."""
    latin = other = 0
    for letter in filter(str.isalpha, unicodedata.normalize("NFKC", text)):
        script = unicodedata.name(letter, "").split()
        if script[:1] == ["LATIN"]:
            latin += 1
        else:
            other += 2 if script and script[0] in _DENSE else 1
    return other > latin


def _is_in_other_words(text: str) -> bool:
    words = _WORD.findall(unicodedata.normalize("NFC", text).casefold())
    return any(_outweighs(words, table) for table in _languages().values())


def _outweighs(words: Sequence[str], table: frozenset[str]) -> bool:
    """Return whether a language's function words outweigh the English ones in a text.

    A word that belongs to both languages counts half on either side. A single foreign word suffices
    if there is no English function word and at most half of the remaining words are in the
    dictionary.
    """
    small = small_words()
    theirs = [word for word in words if word in table]
    others = [word for word in words if word not in table]
    own = [word for word in theirs if not _is_shared(word)]
    found = {word for word in theirs if word in own or len(word) > 1}
    english = sum(word in small for word in others)
    known = sum(_is_known(word) for word in others)
    if not english:
        unknown = len(others) - known
        return bool(own) and (len(found) > 1 or unknown >= max(known, 1))
    foreign = (len(own) + len(theirs)) / 2
    ours = english + sum(word in small for word in theirs) / 2 + _KNOWN * (known - english)
    return len(found) > 1 and foreign > _SHARE * ours


def _is_shared(word: str) -> bool:
    """Return whether a foreign function word also occurs in English texts."""
    if word in small_words() or word in _IN_NAMES or (len(word) == 1 and word.isascii()):
        return True
    entry = entry_of((word,))
    return (entry is not None and entry.is_thing) or (len(word) > 3 and is_english(word))


def _is_known(word: str) -> bool:
    return word in small_words() or (len(word) > 2 and is_english(_plain(word)))


@cache
def _languages() -> Mapping[str, frozenset[str]]:
    """Return each language's words, with and without accents, except English function words."""
    small = small_words()
    found = {}
    for language, listed in _TABLES.items():
        words = {unicodedata.normalize("NFC", word) for word in listed.split()}
        found[language] = frozenset(words | ({_plain(word) for word in words} - small - {"a"}))
    return MappingProxyType(found)


def _plain(word: str) -> str:
    """Return a word without accents."""
    apart = unicodedata.normalize("NFKD", word.translate(_BARRED))
    return "".join(letter for letter in apart if not unicodedata.combining(letter))


_BARRED = str.maketrans({"ø": "o", "ł": "l", "ı": "i", "đ": "d", "ß": "ss", "æ": "ae"})
