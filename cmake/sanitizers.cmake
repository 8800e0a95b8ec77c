# SPDX-License-Identifier: GPL-3.0-or-later
# Compiling under sanitizers takes two to three times as long: the preset asan alone does it.

if(HULL_SANITIZE)
  add_compile_options(-fsanitize=${HULL_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  # A null pointer and the end of an object are the address sanitizer's, too: a third less to compile.
  add_compile_options(-fno-sanitize=null,object-size,alignment)
  add_link_options(-fsanitize=${HULL_SANITIZE})
  # GCC and Clang have no macro in common that tells.
  add_compile_definitions(HULL_SANITIZED)
endif()
