// `vstr` has no limit where `str` takes the short form.
#declare A = vstr(2, <1e300, 1>, ",", 0, 2); #declare B = vstr(3, <1e253, -1e280, 0>, ":", -20, 4);
F(strlen(A)) F(strlen(B)) S(A) S(B) S(str(1e253, 0, 2)) S(str(1e300, 0, 2))
