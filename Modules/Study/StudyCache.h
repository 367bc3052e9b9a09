#pragma once

#include "PalpateStudyModule.h"
#include "SceneProduct.h"

#include <cstddef>
#include <list>
#include <string>
#include <unordered_map>

namespace palpate
{
/// Products by key. If they exceed the memory limit, the least recently used are dropped.
class PALPATESTUDY_EXPORT StudyCache
{
public:
  explicit StudyCache(std::size_t mostBytes) : MostBytes(mostBytes) {}

  /// Null if it is not held; valid until the next Store.
  const SceneProduct* Find(const std::string& key);
  void Store(const std::string& key, SceneProduct product);
  void Forget(const std::string& key);
  std::size_t Bytes() const { return this->HeldBytes; }

private:
  struct Item
  {
    std::string Key;
    SceneProduct Product;
    std::size_t Bytes = 0;
  };

  std::list<Item> Items; ///< most recently used first
  std::unordered_map<std::string, std::list<Item>::iterator> Places;
  std::size_t MostBytes;
  std::size_t HeldBytes = 0;
};
} // namespace palpate
