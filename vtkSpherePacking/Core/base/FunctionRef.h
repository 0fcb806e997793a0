// SPDX-License-Identifier: BSD-3-Clause
#ifndef FunctionRef_h
#define FunctionRef_h

#include <memory>
#include <type_traits>
#include <utility>

namespace spherepacking
{
template <typename Signature>
class FunctionRef;

/// Refers to something that can be called, for as long as that lives: an argument of a function. In
/// contrast to a std::function it allocates nothing, which could fail.
template <typename Result, typename... Arguments>
class FunctionRef<Result(Arguments...)>
{
public:
  template <typename Function,
    typename = std::enable_if_t<!std::is_same_v<std::decay_t<Function>, FunctionRef>>>
  FunctionRef(Function&& function)
    : Object(const_cast<void*>(static_cast<const void*>(std::addressof(function))))
    , Call(
        [](void* object, Arguments... arguments) -> Result
        {
          return (*static_cast<std::add_pointer_t<std::remove_reference_t<Function>>>(object))(
            std::forward<Arguments>(arguments)...);
        })
  {
  }

  Result operator()(Arguments... arguments) const
  {
    return this->Call(this->Object, std::forward<Arguments>(arguments)...);
  }

private:
  void* Object;
  Result (*Call)(void*, Arguments...);
};
}

#endif
