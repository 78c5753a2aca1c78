// SPDX-License-Identifier: Apache-2.0
// The Python types through which scripts read the frame structs in place: one read-only type per
// struct, made from its field list; a member is found by its offset, so no member needs code of its
// own. Keeps the types. A view shows whatever its address holds now: it must not outlive the
// struct.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "behaviour/PythonRef.h"
#include "behaviour/views/PythonNames.h"

namespace kelpie::behaviour {

enum class ItemKind : std::uint8_t { real, boolean, byte, word, number, big, text, view, sequence };

class Members;

// How to make a Python object from bytes at an address.
struct Item {
  ItemKind kind = ItemKind::real;
  std::size_t offset = 0;
  double factor = 1.0;                         // real: from stored to shown; big: seconds per count
  std::size_t number = 0;                      // of a view: among the views of its struct
  PyTypeObject* type = nullptr;                // of a view or sequence
  std::size_t parts = 0;                       // views in it: members, or elements at most
  const Members* members = nullptr;            // of a view
  std::size_t stride = 0;                      // sequence: bytes from one element to the next
  std::size_t (*size)(const char*) = nullptr;  // of a sequence or text
  const Item* element = nullptr;               // of a sequence

  bool isView() const { return kind == ItemKind::view || kind == ItemKind::sequence; }
};

// A struct's members by their names in Python, interned strings that are distinguished by address:
// half the cost of looking a getter up in its type, 400 times in a frame.
class Members {
 public:
  void add(PythonRef name, const Item& item);
  const Item* find(PyObject* name) const;  // null for any other name

 private:
  struct Slot {
    PythonRef name;
    const Item* item = nullptr;
  };
  std::size_t home(PyObject* name) const;
  void put(Slot slot);  // where there is room

  std::vector<Slot> slots_;  // a power of two, at most half of them full
  std::size_t used_ = 0;
};

class ViewTypes {
 public:
  ViewTypes();

  // A read-only view of the object, which must outlive it. Null with a Python error set on failure.
  template <class T>
  PythonRef view(const T& object) {
    return newView(itemFor<T>(""), reinterpret_cast<const char*>(&object));
  }
  bool good() const { return sequence_ && !failed_; }

 private:
  struct ViewType {
    std::string name;               // of its schema
    std::string pythonName;         // with dots
    std::deque<std::string> names;  // deques: the getters point into them
    std::deque<Item> items;
    std::vector<PyGetSetDef> getters;
    Members members;
    PythonRef type;
    std::size_t parts = 0;  // members that are views
  };

  template <class T>
  const ViewType& typeFor();
  template <class T>
  Item itemFor(const char* unit);
  PythonRef newView(const Item& item, const char* data);
  void finish(ViewType& type);

  PythonRef sequence_;
  std::vector<std::unique_ptr<ViewType>> types_;
  std::deque<Item> items_;  // of no struct: elements, and what view() shows; they are pointed at
  bool failed_ = false;
};

template <class T>
Item ViewTypes::itemFor(const char* unit) {
  Item item;
  if constexpr (std::is_same_v<T, bool>) {
    item.kind = ItemKind::boolean;
  } else if constexpr (std::is_enum_v<T>) {
    return itemFor<std::underlying_type_t<T>>(unit);
  } else if constexpr (std::is_same_v<T, double>) {
    item.factor = shownFactor(unit);
  } else if constexpr (std::is_same_v<T, Angle>) {
    static_assert(sizeof(Angle) == sizeof(double));
    item.factor = shownFactor("rad");
  } else if constexpr (std::is_same_v<T, TimeUs>) {
    item.kind = ItemKind::big;
    item.factor = 1e-6;
  } else if constexpr (std::is_integral_v<T>) {
    static_assert(std::is_unsigned_v<T> && sizeof(T) <= 4);
    item.kind = sizeof(T) == 1   ? ItemKind::byte
                : sizeof(T) == 2 ? ItemKind::word
                                 : ItemKind::number;
  } else if constexpr (IsText<T>::value) {
    item.kind = ItemKind::text;
    item.size = [](const char* at) { return reinterpret_cast<const T*>(at)->size(); };
  } else if constexpr (kIsSequence<T>) {
    item.kind = ItemKind::sequence;
    item.type = reinterpret_cast<PyTypeObject*>(sequence_.get());
    item.stride = sizeof(typename T::value_type);
    item.size = [](const char* at) { return reinterpret_cast<const T*>(at)->size(); };
    items_.push_back(itemFor<typename T::value_type>(unit));
    item.element = &items_.back();
    if (item.element->isView()) item.parts = sizeof(T) / sizeof(typename T::value_type);
  } else {
    item.kind = ItemKind::view;
    const ViewType& type = typeFor<T>();
    item.type = reinterpret_cast<PyTypeObject*>(type.type.get());
    item.parts = type.parts;
    item.members = &type.members;
  }
  return item;
}

template <class T>
const ViewTypes::ViewType& ViewTypes::typeFor() {
  const std::string name = schemaName<T>();
  for (const auto& known : types_)
    if (known->name == name) return *known;
  types_.push_back(std::make_unique<ViewType>());
  ViewType* const type = types_.back().get();
  type->name = name;
  const auto sample = std::make_unique<T>();
  forEachField(*sample, [&](const auto& f, const auto& member) {
    using Member = std::decay_t<decltype(member)>;
    Item item = itemFor<Member>(f.unit);
    item.offset = static_cast<std::size_t>(reinterpret_cast<const char*>(&member) -
                                           reinterpret_cast<const char*>(sample.get()));
    if (item.isView()) item.number = type->parts++;
    type->names.push_back(pythonName<Member>(f.name, f.unit));
    type->items.push_back(item);
  });
  finish(*type);
  return *type;
}

}  // namespace kelpie::behaviour
