#include "TextMutator.h"

#include <cctype>
#include <utility>

namespace palpate::test
{
namespace
{
struct Token
{
  std::size_t First;
  std::size_t Count;
};

struct Tokens
{
  std::vector<Token> Numbers;
  std::vector<Token> Words;
  std::vector<Token> Marks; // single characters
  std::vector<Token> Lines; // with their line breaks
};

bool IsDigit(char sign)
{
  return std::isdigit(static_cast<unsigned char>(sign)) != 0;
}

bool IsLetter(char sign)
{
  return std::isalpha(static_cast<unsigned char>(sign)) != 0 || sign == '_';
}

bool BeginsNumber(const std::string& text, std::size_t place)
{
  const bool isSigned = text[place] == '-' || text[place] == '+' || text[place] == '.';
  return IsDigit(text[place]) || (isSigned && place + 1 < text.size() && IsDigit(text[place + 1]));
}

bool GoesOn(const std::string& text, std::size_t place, bool isNumber)
{
  const char sign = text[place];
  if (isNumber)
  {
    const bool isExponent = (text[place - 1] | 32) == 'e';
    return IsDigit(sign) || sign == '.' || (sign | 32) == 'e' ||
           (isExponent && (sign == '-' || sign == '+'));
  }
  return IsLetter(sign) || IsDigit(sign) || sign == '-';
}

Tokens TokensOf(const std::string& text)
{
  const std::size_t end = text.size();
  Tokens tokens;
  std::size_t line = 0;
  for (std::size_t place = 0; place < end;)
  {
    const bool isNumber = BeginsNumber(text, place);
    std::size_t next = place + 1;
    if (isNumber || IsLetter(text[place]))
    {
      while (next < end && GoesOn(text, next, isNumber))
      {
        ++next;
      }
      (isNumber ? tokens.Numbers : tokens.Words).push_back({place, next - place});
    }
    else if (std::isspace(static_cast<unsigned char>(text[place])) == 0)
    {
      tokens.Marks.push_back({place, 1});
    }
    if (text[place] == '\n' || next >= end)
    {
      tokens.Lines.push_back({line, next - line});
      line = next;
    }
    place = next;
  }
  return tokens;
}

std::string TextOf(const std::string& text, const Token& token)
{
  return text.substr(token.First, token.Count);
}

void Replace(std::string& text, const Token& token, const std::string& by)
{
  text.replace(token.First, token.Count, by);
}

// Lengths near the sizes of fixed buffers in parsers.
std::size_t OddLength(Random& random)
{
  static constexpr std::size_t Odd[] = {1, 63, 64, 255, 256, 1000, 1024, 4096, 30000};
  return Choose(Odd, random);
}

class TextChange
{
public:
  TextChange(std::string& text, const TextGrammar& grammar, Random& random)
      : Text(text), Grammar(grammar), Numbers(random), Found(TokensOf(text))
  {
  }

  void Make()
  {
    static constexpr void (TextChange::*Paths[])() = {
        &TextChange::ChangeNumber, &TextChange::ChangeNumber, &TextChange::ChangeNumber,
        &TextChange::ChangeWord,   &TextChange::ChangeWord,   &TextChange::ChangeMark,
        &TextChange::RepeatLine,   &TextChange::RemoveLine,   &TextChange::SwapLines,
        &TextChange::RepeatToken,  &TextChange::RemoveToken,  &TextChange::Lengthen,
        &TextChange::Nest,         &TextChange::InsertOddText};
    (this->*Choose(Paths, this->Numbers))();
  }

private:
  bool Pick(const std::vector<Token>& tokens, Token& token)
  {
    if (tokens.empty())
    {
      return false;
    }
    token = Choose(tokens, this->Numbers);
    return true;
  }
  const std::vector<Token>& AnyKind()
  {
    const std::vector<Token>* kinds[] = {&this->Found.Numbers, &this->Found.Words,
                                         &this->Found.Marks};
    return *Choose(kinds, this->Numbers);
  }

  void ChangeNumber()
  {
    Token token{};
    if (this->Pick(this->Found.Numbers, token))
    {
      Replace(this->Text, token, OddNumberText(this->Numbers));
    }
  }
  void ChangeWord()
  {
    Token token{};
    Token other{};
    if (!this->Pick(this->Found.Words, token) || !this->Pick(this->Found.Words, other))
    {
      return;
    }
    const bool fromFile = this->Grammar.Words.empty() || Below(this->Numbers, 2) == 0;
    Replace(this->Text, token,
            fromFile ? TextOf(this->Text, other) : Choose(this->Grammar.Words, this->Numbers));
  }
  void ChangeMark()
  {
    Token token{};
    Token other{};
    if (this->Pick(this->Found.Marks, token) && this->Pick(this->Found.Marks, other))
    {
      Replace(this->Text, token, TextOf(this->Text, other));
    }
  }
  void RepeatLine()
  {
    Token line{};
    if (!this->Pick(this->Found.Lines, line))
    {
      return;
    }
    static constexpr std::size_t Counts[] = {1, 2, 10, 1000};
    const std::string text = TextOf(this->Text, line);
    std::string repeated;
    for (std::size_t n = Choose(Counts, this->Numbers); n > 0 && repeated.size() < 30000; --n)
    {
      repeated += text;
    }
    this->Text.insert(line.First, repeated);
  }
  void RemoveLine()
  {
    Token line{};
    if (this->Pick(this->Found.Lines, line))
    {
      Replace(this->Text, line, "");
    }
  }
  void SwapLines()
  {
    Token a{};
    Token b{};
    if (!this->Pick(this->Found.Lines, a) || !this->Pick(this->Found.Lines, b))
    {
      return;
    }
    if (a.First > b.First)
    {
      std::swap(a, b);
    }
    if (a.First != b.First)
    {
      const std::string text = TextOf(this->Text, a);
      Replace(this->Text, a, "");
      this->Text.insert(b.First + b.Count - a.Count, text);
    }
  }
  void RepeatToken()
  {
    Token token{};
    if (this->Pick(this->AnyKind(), token))
    {
      const std::string text = TextOf(this->Text, token);
      static const std::string Between[] = {"", " ", ",", "\n", "\t"};
      this->Text.insert(token.First, text + Choose(Between, this->Numbers));
    }
  }
  void RemoveToken()
  {
    Token token{};
    if (this->Pick(this->AnyKind(), token))
    {
      Replace(this->Text, token, "");
    }
  }
  void Lengthen()
  {
    Token token{};
    if (this->Pick(this->AnyKind(), token))
    {
      this->Text.insert(token.First + token.Count, OddLength(this->Numbers),
                        this->Text[token.First]);
    }
  }
  void Nest()
  {
    Token token{};
    if (this->Grammar.Brackets.empty() || !this->Pick(this->AnyKind(), token))
    {
      this->ChangeNumber();
      return;
    }
    const auto& [open, close] = Choose(this->Grammar.Brackets, this->Numbers);
    Replace(this->Text, token,
            Nested(OddDepth(this->Numbers), open, TextOf(this->Text, token), close));
  }
  void InsertOddText()
  {
    static const std::string Odd[] = {std::string(1, '\0'),
                                      "\r\n",
                                      "\r",
                                      "\n\n",
                                      " ",
                                      "\"",
                                      "'",
                                      ",",
                                      ";",
                                      ":",
                                      "#",
                                      "%s",
                                      "\xFF",
                                      "\xC3",
                                      "\xEF\xBB\xBF",
                                      "\\u0000",
                                      "../",
                                      "\t",
                                      "=",
                                      "&amp;"};
    this->Text.insert(Below(this->Numbers, this->Text.size() + 1), Choose(Odd, this->Numbers));
  }

  std::string& Text;
  const TextGrammar& Grammar;
  Random& Numbers;
  Tokens Found;
};
} // namespace

Mutator TextMutator(TextGrammar grammar)
{
  return [known = std::move(grammar)](std::string& text, Random& random)
  {
    const std::string& end = known.HeadEnd;
    const std::size_t found = end.empty() ? std::string::npos : text.find(end);
    const std::size_t headLength = found == std::string::npos ? text.size() : found + end.size();
    std::string head = text.substr(0, headLength);
    for (std::size_t changes = 1 + Below(random, 2); changes > 0; --changes)
    {
      TextChange(head, known, random).Make();
    }
    text.replace(0, headLength, head);
  };
}

std::string Nested(std::size_t depth, const std::string& open, const std::string& inner,
                   const std::string& close)
{
  std::string text;
  text.reserve(depth * (open.size() + close.size()) + inner.size());
  for (std::size_t level = 0; level < depth; ++level)
  {
    text += open;
  }
  text += inner;
  for (std::size_t level = 0; level < depth; ++level)
  {
    text += close;
  }
  return text;
}

std::size_t OddDepth(Random& random)
{
  static constexpr std::size_t Depths[] = {1, 2, 10, 100, 1000, 10000, 40000, 100000};
  return Choose(Depths, random);
}
} // namespace palpate::test
