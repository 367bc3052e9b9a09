#include "JsonMutator.h"

#include "TextMutator.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace palpate::test
{
namespace
{
using Json = nlohmann::ordered_json;

// Placeholder for text that is too deeply nested for the library's recursive functions.
constexpr const char* DeepMark = "@deep@";

// Copying and writing JSON in the library, and Collect below, are recursive.
bool IsShallow(const std::string& text)
{
  constexpr int Deepest = 200;
  int depth = 0;
  int deepest = 0;
  for (const char sign : text)
  {
    depth += sign == '[' || sign == '{' ? 1 : 0;
    depth -= sign == ']' || sign == '}' ? 1 : 0;
    deepest = std::max(deepest, depth);
  }
  return deepest <= Deepest;
}

void Collect(Json& node, std::vector<Json*>& nodes)
{
  nodes.push_back(&node);
  if (node.is_structured())
  {
    for (Json& child : node)
    {
      Collect(child, nodes);
    }
  }
}

Json OddNumber(const Json& present, Random& random)
{
  if (Below(random, 2) == 0)
  {
    return OddReal(present.is_number() ? present.get<double>() : 1.0, random);
  }
  const auto whole = present.is_number_integer() ? present.get<std::uint64_t>() : 1;
  return static_cast<std::int64_t>(OddInteger(whole, random));
}

Json OddText(const std::vector<std::string>& words, Random& random)
{
  static const std::string Odd[] = {"",
                                    " ",
                                    "../../etc/passwd",
                                    "/",
                                    ".",
                                    "\n",
                                    std::string(1, '\0'),
                                    "\xFF",
                                    "\xC3\xA4",
                                    "=1+1",
                                    "<b>",
                                    std::string(5000, 'a')};
  return words.empty() || Below(random, 2) == 0 ? Choose(Odd, random) : Choose(words, random);
}

Json OddValue(const Json& present, const std::vector<Json*>& nodes,
              const std::vector<std::string>& words, Random& random)
{
  switch (Below(random, 9))
  {
  case 0:
    return nullptr;
  case 1:
    return Below(random, 2) == 0;
  case 2:
    return Json::array();
  case 3:
    return Json::object();
  case 4:
    return DeepMark;
  case 5:
    return *Choose(nodes, random);
  case 6:
    return OddText(words, random);
  default:
    return OddNumber(present, random);
  }
}

// Adds or removes an entry.
void ChangeEntries(Json& node, const std::vector<std::string>& words, Random& random)
{
  if (node.is_array() && !node.empty())
  {
    const Json item = node[Below(random, node.size())];
    if (Below(random, 3) == 0)
    {
      node.erase(Below(random, node.size()));
      return;
    }
    static constexpr std::size_t Counts[] = {1, 3, 50, 1000};
    const std::size_t count = Choose(Counts, random);
    for (std::size_t n = 0; n < count; ++n)
    {
      node.push_back(item);
    }
  }
  else if (node.is_object() && !node.empty())
  {
    const auto entry =
        std::next(node.begin(), static_cast<std::ptrdiff_t>(Below(random, node.size())));
    const std::string key = entry.key();
    const Json value = entry.value();
    if (Below(random, 2) == 0)
    {
      node.erase(key);
    }
    if (Below(random, 2) == 0)
    {
      node[words.empty() ? key + "x" : Choose(words, random)] = value;
    }
  }
}

void ChangeTree(Json& root, const std::vector<std::string>& words, Random& random)
{
  std::vector<Json*> nodes;
  Collect(root, nodes);
  Json& node = *Choose(nodes, random);
  if (node.is_structured() && Below(random, 2) == 0)
  {
    ChangeEntries(node, words, random);
    return;
  }
  // A separate variable, because it may be a copy of a part of the node.
  Json odd = OddValue(node, nodes, words, random);
  node = std::move(odd);
}

std::string DeepText(Random& random)
{
  const bool isList = Below(random, 2) == 0;
  return isList ? Nested(OddDepth(random), "[", "", "]")
                : Nested(OddDepth(random), "{\"a\":", "1", "}");
}

std::string TextOf(const Json& root, Random& random)
{
  std::string text =
      root.dump(Below(random, 3) == 0 ? -1 : 1, ' ', false, Json::error_handler_t::ignore);
  const std::string mark = std::string("\"") + DeepMark + "\"";
  const std::size_t place = text.find(mark);
  return place == std::string::npos ? text : text.replace(place, mark.size(), DeepText(random));
}
} // namespace

Mutator JsonMutator(std::vector<std::string> words)
{
  const Mutator changeText = TextMutator({words, {{"[", "]"}, {"{\"a\":", "}"}}, ""});
  return [known = std::move(words), changeText](std::string& text, Random& random)
  {
    const bool isShallow = IsShallow(text);
    Json root = isShallow ? Json::parse(text, nullptr, false) : Json();
    const bool isTree = isShallow && !root.is_discarded();
    for (std::size_t changes = isTree ? 1 + Below(random, 2) : 0; changes > 0; --changes)
    {
      ChangeTree(root, known, random);
    }
    if (isTree)
    {
      text = TextOf(root, random);
    }
    if (!isTree || Below(random, 4) == 0)
    {
      changeText(text, random);
    }
  };
}
} // namespace palpate::test
