def add_all(corpus): pass
