// SPDX-License-Identifier: Apache-2.0
#include "behaviour/views/ViewTypes.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace kelpie::behaviour {
namespace {

// Of a struct or a sequence. Behind it stand its parts that are views themselves, each from the
// first time that it is asked for: as many as its ob_size.
struct View {
  PyObject_VAR_HEAD;
  const char* data;
  const Item* item;  // what it shows
};

PyObject** partsOf(View* view) { return reinterpret_cast<PyObject**>(view + 1); }

template <class T>
T read(const char* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

PyObject* makeView(const Item& item, const char* data) {
  auto* view = PyObject_NewVar(View, item.type, static_cast<Py_ssize_t>(item.parts));
  if (view == nullptr) return nullptr;
  view->data = data;
  view->item = &item;
  std::fill_n(partsOf(view), item.parts, nullptr);
  return reinterpret_cast<PyObject*>(view);
}

PyObject* make(const Item& item, const char* at) {
  switch (item.kind) {
    case ItemKind::real: return PyFloat_FromDouble(item.factor * read<double>(at));
    case ItemKind::boolean: return PyBool_FromLong(read<std::uint8_t>(at));
    case ItemKind::byte: return PyLong_FromUnsignedLong(read<std::uint8_t>(at));
    case ItemKind::word: return PyLong_FromUnsignedLong(read<std::uint16_t>(at));
    case ItemKind::number: return PyLong_FromUnsignedLong(read<std::uint32_t>(at));
    case ItemKind::big:
      return PyFloat_FromDouble(item.factor * static_cast<double>(read<std::int64_t>(at)));
    case ItemKind::text:
      return PyUnicode_DecodeUTF8(at, static_cast<Py_ssize_t>(item.size(at)), "replace");
    case ItemKind::view:
    case ItemKind::sequence: return makeView(item, at);
  }
  Py_RETURN_NONE;
}

// A view always shows the same place: the one that was made at first serves all frames.
PyObject* part(View* view, std::size_t number, const Item& item, const char* at) {
  if (!item.isView()) return make(item, at);
  PyObject*& kept = partsOf(view)[number];
  if (kept == nullptr) kept = make(item, at);
  Py_XINCREF(kept);
  return kept;
}

PyObject* getMember(PyObject* self, void* closure) {
  const Item& item = *static_cast<const Item*>(closure);
  auto* const view = reinterpret_cast<View*>(self);
  return part(view, item.number, item, view->data + item.offset);
}

// Names that are no member's, or not interned, go the usual way.
PyObject* getAttribute(PyObject* self, PyObject* name) {
  auto* const view = reinterpret_cast<View*>(self);
  const Item* item = view->item->members->find(name);
  if (item == nullptr) return PyObject_GenericGetAttr(self, name);
  return part(view, item->number, *item, view->data + item->offset);
}

Py_ssize_t sequenceLength(PyObject* self) {
  const auto* sequence = reinterpret_cast<View*>(self);
  return static_cast<Py_ssize_t>(sequence->item->size(sequence->data));
}

PyObject* sequenceItem(PyObject* self, Py_ssize_t index) {
  auto* const sequence = reinterpret_cast<View*>(self);
  if (index < 0 || index >= sequenceLength(self)) {
    PyErr_SetString(PyExc_IndexError, "beyond the last element");
    return nullptr;
  }
  const auto number = static_cast<std::size_t>(index);
  const Item& item = *sequence->item;
  return part(sequence, number, *item.element, sequence->data + number * item.stride);
}

// Heap types own a reference from each of their objects.
void dealloc(PyObject* self) {
  PyTypeObject* type = Py_TYPE(self);
  PyObject** const parts = partsOf(reinterpret_cast<View*>(self));
  for (Py_ssize_t i = 0; i < Py_SIZE(self); ++i) Py_XDECREF(parts[i]);
  type->tp_free(self);
  Py_DECREF(type);
}

template <class Function>
void* slot(Function* function) {
  return reinterpret_cast<void*>(function);
}

constexpr unsigned kTypeFlags =
    Py_TPFLAGS_DEFAULT | Py_TPFLAGS_DISALLOW_INSTANTIATION | Py_TPFLAGS_IMMUTABLETYPE;

}  // namespace

std::size_t Members::home(PyObject* name) const {
  // Python's blocks lie 16 bytes apart; the upper bits part those of one row.
  const auto place = reinterpret_cast<std::uintptr_t>(name) >> 4U;
  return (place ^ (place >> 6U)) & (slots_.size() - 1);
}

void Members::add(PythonRef name, const Item& item) {
  if (2 * (used_ + 1) > slots_.size()) {
    std::vector<Slot> before(std::max<std::size_t>(4, 2 * slots_.size()));
    std::swap(before, slots_);
    for (Slot& slot : before)
      if (slot.name) put(std::move(slot));
  }
  put({std::move(name), &item});
  ++used_;
}

void Members::put(Slot slot) {
  std::size_t at = home(slot.name.get());
  while (slots_[at].name) at = (at + 1) & (slots_.size() - 1);
  slots_[at] = std::move(slot);
}

const Item* Members::find(PyObject* name) const {
  if (slots_.empty()) return nullptr;
  for (std::size_t at = home(name); slots_[at].name; at = (at + 1) & (slots_.size() - 1))
    if (slots_[at].name.get() == name) return slots_[at].item;
  return nullptr;
}

ViewTypes::ViewTypes() {
  PyType_Slot slots[] = {{Py_tp_dealloc, slot(dealloc)},
                         {Py_sq_length, slot(sequenceLength)},
                         {Py_sq_item, slot(sequenceItem)},
                         {0, nullptr}};
  PyType_Spec spec{"kelpie.Sequence", static_cast<int>(sizeof(View)), sizeof(PyObject*), kTypeFlags,
                   slots};
  sequence_ = PythonRef(PyType_FromSpec(&spec));
}

PythonRef ViewTypes::newView(const Item& item, const char* data) {
  items_.push_back(item);
  return PythonRef(item.type == nullptr ? nullptr : makeView(items_.back(), data));
}

void ViewTypes::finish(ViewType& type) {
  for (std::size_t i = 0; i < type.items.size(); ++i) {
    type.getters.push_back({type.names[i].c_str(), getMember, nullptr, nullptr, &type.items[i]});
    PythonRef name(PyUnicode_InternFromString(type.names[i].c_str()));
    if (name) type.members.add(std::move(name), type.items[i]);
  }
  type.getters.push_back({nullptr, nullptr, nullptr, nullptr, nullptr});
  type.pythonName = type.name;
  std::replace(type.pythonName.begin(), type.pythonName.end(), '/', '.');
  PyType_Slot slots[] = {{Py_tp_dealloc, slot(dealloc)},
                         {Py_tp_getattro, slot(getAttribute)},
                         {Py_tp_getset, type.getters.data()},
                         {0, nullptr}};
  PyType_Spec spec{type.pythonName.c_str(), static_cast<int>(sizeof(View)), sizeof(PyObject*),
                   kTypeFlags, slots};
  type.type = PythonRef(PyType_FromSpec(&spec));
  if (!type.type) failed_ = true;
}

}  // namespace kelpie::behaviour
