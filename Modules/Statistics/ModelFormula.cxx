#include "ModelFormula.h"

#include "DecimalText.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <utility>

namespace palpate
{
namespace
{
using Transform = FormulaVariable::Transform;

struct NamedTransform
{
  const char* Name;
  Transform Function;
};
constexpr std::array<NamedTransform, 6> Transforms{{{"log", Transform::Log},
                                                    {"log2", Transform::Log2},
                                                    {"log10", Transform::Log10},
                                                    {"sqrt", Transform::Sqrt},
                                                    {"exp", Transform::Exp},
                                                    {"factor", Transform::Factor}}};
constexpr int LargestExponent = 9;
constexpr std::size_t MostTerms = 200;

bool IsNameCharacter(char letter)
{
  const auto byte = static_cast<unsigned char>(letter);
  return std::isalnum(byte) != 0 || letter == '_' || letter == '.' || byte >= 0x80;
}

std::string Quoted(const std::string& name)
{
  const bool isPlain = !name.empty() && std::all_of(name.begin(), name.end(), IsNameCharacter) &&
                       std::isdigit(static_cast<unsigned char>(name.front())) == 0;
  return isPlain ? name : "`" + name + "`";
}

/// Recursive descent over sums of products of variables. The first error remains.
class FormulaParser
{
public:
  explicit FormulaParser(const std::string& text) : Text(text) {}

  std::vector<ModelFormula::Term> Terms()
  {
    this->Take('~');
    std::vector<ModelFormula::Term> terms;
    do
    {
      this->AddProduct(terms);
    } while (this->Error.empty() && this->Take('+'));
    if (this->Error.empty() && this->Peek() != '\0')
    {
      this->Fail("expected + : or *");
    }
    return terms;
  }
  const std::string& Failure() const { return this->Error; }

private:
  char Peek()
  {
    while (this->Place < this->Text.size() &&
           std::isspace(static_cast<unsigned char>(this->Text[this->Place])) != 0)
    {
      ++this->Place;
    }
    return this->Place < this->Text.size() ? this->Text[this->Place] : '\0';
  }
  bool Take(char wanted)
  {
    const bool isThere = this->Peek() == wanted && wanted != '\0';
    this->Place += isThere ? 1U : 0U;
    return isThere;
  }
  void Fail(const std::string& what)
  {
    if (this->Error.empty())
    {
      this->Error = "formula \"" + this->Text + "\", character " + std::to_string(this->Place + 1) +
                    ": " + what;
    }
  }

  // a*b is a + b + a:b.
  void AddProduct(std::vector<ModelFormula::Term>& terms)
  {
    std::vector<ModelFormula::Term> product = this->Interaction();
    while (this->Error.empty() && this->Take('*'))
    {
      const std::vector<ModelFormula::Term> next = this->Interaction();
      std::vector<ModelFormula::Term> crossed;
      for (const ModelFormula::Term& left : product)
      {
        for (const ModelFormula::Term& right : next)
        {
          crossed.push_back(left);
          crossed.back().insert(crossed.back().end(), right.begin(), right.end());
        }
      }
      product.insert(product.end(), next.begin(), next.end());
      product.insert(product.end(), crossed.begin(), crossed.end());
      if (product.size() > MostTerms)
      {
        this->Fail("too many terms");
      }
    }
    terms.insert(terms.end(), product.begin(), product.end());
  }
  // Empty for the intercept, "1".
  std::vector<ModelFormula::Term> Interaction()
  {
    if (this->Take('1'))
    {
      return {};
    }
    ModelFormula::Term term{this->Variable()};
    while (this->Error.empty() && this->Take(':'))
    {
      term.push_back(this->Variable());
    }
    return {term};
  }
  FormulaVariable Variable()
  {
    FormulaVariable variable;
    const bool isQuoted = this->Peek() == '`';
    const std::string name = this->Name();
    variable.Column = name;
    if (isQuoted || !this->Take('('))
    {
      return variable;
    }
    variable.Column = this->Name();
    const auto* const known =
        std::find_if(Transforms.begin(), Transforms.end(),
                     [&](const NamedTransform& one) { return name == one.Name; });
    if (name == "I")
    {
      variable.Function = Transform::Power;
      variable.Exponent = this->Exponent();
    }
    else if (known != Transforms.end())
    {
      variable.Function = known->Function;
    }
    else
    {
      this->Fail("the functions are log, log2, log10, sqrt, exp, factor and I(name^exponent)");
    }
    if (!this->Take(')'))
    {
      this->Fail("expected )");
    }
    return variable;
  }
  int Exponent()
  {
    const bool isPower = this->Take('^');
    const char digit = this->Peek();
    if (!isPower || digit < '2' || digit > '0' + LargestExponent)
    {
      this->Fail("expected ^ and an exponent from 2 to 9");
      return 1;
    }
    ++this->Place;
    return digit - '0';
  }
  std::string Name()
  {
    std::string name;
    if (this->Take('`'))
    {
      const std::size_t end = this->Text.find('`', this->Place);
      if (end == std::string::npos)
      {
        this->Fail("the back quote has no second one");
        return name;
      }
      name = this->Text.substr(this->Place, end - this->Place);
      this->Place = end + 1;
    }
    else if (std::isdigit(static_cast<unsigned char>(this->Peek())) == 0)
    {
      while (this->Place < this->Text.size() && IsNameCharacter(this->Text[this->Place]))
      {
        name += this->Text[this->Place++];
      }
    }
    if (name.empty())
    {
      this->Fail("expected the name of a column; the intercept can't be left out");
    }
    return name;
  }

  const std::string& Text;
  std::size_t Place = 0;
  std::string Error;
};

std::vector<std::string> SortedTexts(const ModelFormula::Term& term)
{
  std::vector<std::string> texts;
  for (const FormulaVariable& variable : term)
  {
    texts.push_back(variable.Text());
  }
  std::sort(texts.begin(), texts.end());
  return texts;
}

// In an interaction a variable counts once.
ModelFormula::Term WithoutRepeats(const ModelFormula::Term& term)
{
  ModelFormula::Term unique;
  for (const FormulaVariable& variable : term)
  {
    if (std::none_of(unique.begin(), unique.end(),
                     [&](const FormulaVariable& one) { return one.Text() == variable.Text(); }))
    {
      unique.push_back(variable);
    }
  }
  return unique;
}
} // namespace

std::string FormulaVariable::Text() const
{
  const std::string name = Quoted(this->Column);
  if (this->Function == Transform::None)
  {
    return name;
  }
  if (this->Function == Transform::Power)
  {
    return "I(" + name + "^" + std::to_string(this->Exponent) + ")";
  }
  const auto* const known =
      std::find_if(Transforms.begin(), Transforms.end(),
                   [&](const NamedTransform& one) { return one.Function == this->Function; });
  return std::string(known->Name) + "(" + name + ")";
}

std::string TextOf(const ModelFormula::Term& term)
{
  std::string text;
  for (const FormulaVariable& variable : term)
  {
    text += (text.empty() ? "" : ":") + variable.Text();
  }
  return text;
}

Status ModelFormula::Parse(const std::string& text, ModelFormula& formula)
{
  FormulaParser parser(text);
  const std::vector<Term> terms = parser.Terms();
  if (!parser.Failure().empty())
  {
    return Status::Failure(parser.Failure());
  }
  ModelFormula result;
  for (const Term& term : terms)
  {
    const Term unique = WithoutRepeats(term);
    if (std::none_of(result.Content.begin(), result.Content.end(),
                     [&](const Term& one) { return SortedTexts(one) == SortedTexts(unique); }))
    {
      result.Content.push_back(unique);
    }
  }
  std::stable_sort(result.Content.begin(), result.Content.end(),
                   [](const Term& a, const Term& b) { return a.size() < b.size(); });
  if (result.Content.empty() || result.Content.size() > MostTerms)
  {
    return Status::Failure(
        "formula \"" + text + "\" has " +
        (result.Content.empty() ? "no covariate; write ~ age + group" : "more than 200 terms"));
  }
  formula = std::move(result);
  return Status::Success();
}

std::vector<std::string> ModelFormula::Columns() const
{
  std::vector<std::string> columns;
  for (const Term& term : this->Content)
  {
    for (const FormulaVariable& variable : term)
    {
      if (std::find(columns.begin(), columns.end(), variable.Column) == columns.end())
      {
        columns.push_back(variable.Column);
      }
    }
  }
  return columns;
}

std::string ModelFormula::Text() const
{
  std::string text;
  for (const Term& term : this->Content)
  {
    text += (text.empty() ? "~ " : " + ") + TextOf(term);
  }
  return text;
}
} // namespace palpate
