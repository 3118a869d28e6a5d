# cmake -DFROM=page.html -DTO=page.cpp -P Embed.cmake    a file as bytes of a C++ source that defines gyromode::embedded_page()
file(READ ${FROM} bytes HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
string(REGEX REPLACE "((0x[0-9a-f][0-9a-f],)(0x[0-9a-f][0-9a-f],)(0x[0-9a-f][0-9a-f],)(0x[0-9a-f][0-9a-f],)(0x[0-9a-f][0-9a-f],)(0x[0-9a-f][0-9a-f],)(0x[0-9a-f][0-9a-f],)(0x[0-9a-f][0-9a-f],))" "\\1\n" bytes "${bytes}")
file(WRITE ${TO} "#include \"gyromode/html/embedded_page.h\"\n\nnamespace gyromode {\nnamespace {\nconst unsigned char bytes[] = {\n${bytes}\n};\n}\n"
  "std::string_view embedded_page() { return {reinterpret_cast<const char*>(bytes), sizeof bytes}; }\n}\n")
